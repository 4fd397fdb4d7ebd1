#include "journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "share_work.hpp"
#include "signorini/output.hpp"

namespace signorini {

Journal::Journal(const std::string& path, const std::string& question, bool resumes)
    : name_(nameFor(path))
{
    std::string kept;
    if (std::ifstream before(name_, std::ios::binary); resumes && before) {
        std::ostringstream all;
        all << before.rdbuf();
        kept = all.str();
        kept.erase(kept.rfind('\n') == std::string::npos ? 0 : kept.rfind('\n') + 1);
        std::istringstream lines(kept);
        std::string line;
        if (std::getline(lines, line) && line != question) {
            throw std::invalid_argument(
                fmt::format("{}: the run that it began is of another question: allowed the same "
                            "call, or another file",
                            path));
        }
        while (std::getline(lines, line)) {
            known_.push_back(line);
        }
    }
    if (!kept.empty()) {
        std::error_code error;
        std::filesystem::resize_file(name_, kept.size(), error);  // what was cut short goes
    }
    file_ = std::fopen(name_.c_str(), kept.empty() ? "wb" : "ab");
    if (file_ == nullptr) {
        throw FileError(name_, "cannot write it");
    }
    if (kept.empty()) {
        try {
            add(question);
        } catch (const FileError&) {
            (void)std::fclose(file_);
            throw;
        }
    }
}

Journal::~Journal()
{
    if (file_ != nullptr) {
        (void)std::fclose(file_);
    }
}

void Journal::add(const std::string& line)
{
    const std::string whole = line + "\n";
    if (std::fwrite(whole.data(), 1, whole.size(), file_) != whole.size() ||
        std::fflush(file_) != 0) {
        throw FileError(name_, "cannot write it");
    }
}

void Journal::remove()
{
    (void)std::remove(name_.c_str());
}

DealRows byThreads(const RowOf& row, std::int64_t threads)
{
    return [row, threads](const std::vector<std::size_t>& which, const TakeRow& take) {
        std::mutex mutex;
        const auto serve = [&](std::size_t at) {
            const std::size_t k = which[which.size() - 1 - at];  // served from the last
            const std::optional<std::string> line = row(k);
            if (line) {
                const std::lock_guard lock(mutex);
                take(k, *line);
            }
            return line.has_value();
        };
        shareWork(which.size(), threads, serve, {});
    };
}

namespace {

/// The rows of a table that is there.
std::vector<std::string> rowsThere(const RowTable& table)
{
    std::ifstream file(table.file);
    std::string line;
    if (!file || !std::getline(file, line)) {
        return {};
    }
    if (line != "# " + table.question) {
        throw std::invalid_argument(fmt::format(
            "{}: it is of another question: allowed the same one, or another file", table.file));
    }
    std::vector<std::string> rows;
    std::getline(file, line);
    while (std::getline(file, line)) {
        rows.push_back(line);
    }
    return rows;
}

void writeTable(const RowTable& table, const std::vector<std::string>& rows)
{
    OutputFiles outputs;
    TextFile file(outputs.stage(table.file));
    file.write(fmt::format("# {}\n{}\n{}\n", table.question, table.header, fmt::join(rows, "\n")));
    file.close();
    outputs.commit();
}

}  // namespace

std::vector<std::string> tabulated(const RowTable& table)
{
    std::vector<std::string> known;
    std::optional<Journal> journal;
    if (!table.file.empty()) {
        known = table.resumes ? rowsThere(table) : known;
        journal.emplace(table.file, table.question, table.resumes);
        known.insert(known.end(), journal->known().begin(), journal->known().end());
    }
    std::vector<std::string> rows(table.keys.size());
    std::vector<std::string> others;
    for (const std::string& row : known) {
        const auto key = std::find_if(table.keys.begin(), table.keys.end(),
                                      [&row](const auto& begin) { return row.starts_with(begin); });
        if (key == table.keys.end()) {
            others.push_back(row);
        } else {
            rows[static_cast<std::size_t>(key - table.keys.begin())] = row;
        }
    }
    std::vector<std::size_t> missing;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (rows[k].empty()) {
            missing.push_back(k);
        }
    }
    auto done = static_cast<double>(rows.size() - missing.size());
    table.deal(missing, [&](std::size_t k, const std::string& row) {
        rows[k] = row;
        if (journal) {
            journal->add(row);
        }
        if (table.show) {
            table.show(++done, static_cast<double>(rows.size()));
        }
    });
    const bool isWhole =
        std::none_of(rows.begin(), rows.end(), [](const std::string& row) { return row.empty(); });
    if (journal && isWhole) {
        others.insert(others.begin(), rows.begin(), rows.end());
        writeTable(table, others);
        journal->remove();
    }
    return rows;
}

namespace {

/// Collects numbers that it is shown.
struct Written {
    std::vector<double> all;

    void operator()(const auto&... numbers) { (all.push_back(static_cast<double>(numbers)), ...); }
};

/// Enters those of a line, one after the other.
class Numbers {
public:
    explicit Numbers(const std::string& line) : at_(line.c_str()) {}

    template <typename... Number>
    void operator()(Number&... numbers)
    {
        ((numbers = static_cast<Number>(next())), ...);
    }
    [[nodiscard]] std::string rest() const { return *at_ == ' ' ? at_ + 1 : at_; }

private:
    double next()
    {
        char* end = nullptr;
        const double value = std::strtod(at_, &end);
        if (end == at_) {
            throw std::invalid_argument(
                "a line of the run that was begun is damaged: allowed the "
                "file as it was left, or a new run");
        }
        at_ = end;
        return value;
    }

    const char* at_;
};

template <typename See, typename Item, typename Pass>
void passAll(See& see, std::vector<Item>& items, Pass pass)
{
    auto count = static_cast<std::int64_t>(items.size());
    see(count);
    for (std::int64_t k = 0; k < count; ++k) {
        if (k == std::ssize(items)) {
            items.emplace_back();
        }
        pass(items[static_cast<std::size_t>(k)]);
    }
}

/// The numbers of a step in the order of a line, to be written or entered.
template <typename See>
void passNumbers(See& see, SweepStep& step)
{
    SweepPoint& p = step.point;
    double isDown = p.direction == SweepDirection::down ? 1.0 : 0.0;
    double knowsStrain = 1.0;
    see(p.value, p.frequencyRatio, isDown, p.watched, p.contacts[0], p.contacts[1], p.impulse[0],
        p.impulse[1], p.meanContacts, p.meanImpulse, p.meanForce, p.tip[0], p.tip[1], knowsStrain);
    if (knowsStrain == 0.0) {  // written before sweeps of several bars knew it
        throw std::invalid_argument(
            "the run that was begun says nothing of strain: allowed a new run");
    }
    p.direction = isDown == 0.0 ? SweepDirection::up : SweepDirection::down;
    Settled settled = p.settling.settled.value_or(Settled{});
    see(p.strain, settled.periods, settled.residual, settled.contacts, settled.impulse);
    p.settling.settled = settled.periods > 0 ? std::optional(settled) : std::nullopt;
    passAll(see, p.impulses, [&see](double& impulse) { see(impulse); });
    Waves& waves = step.waves;
    double hasBase = waves.base ? 1.0 : 0.0;
    double base = waves.base.value_or(0.0);
    see(waves.crossing, hasBase, base);
    waves.base = hasBase != 0.0 ? std::optional(base) : std::nullopt;
    for (auto* wave : {&waves.a, &waves.b}) {
        passAll(see, *wave, [&see](Piece& piece) { see(piece.duration, piece.value); });
    }
}

/// A step of a sweep as a line, and back, to the last bit.
std::string lineOf(SweepStep step)
{
    Written written;
    passNumbers(written, step);
    return fmt::format("{} {}", fmt::join(written.all, " "), step.point.settling.why);
}

SweepStep sweepStepOf(const std::string& line)
{
    Numbers numbers(line);
    SweepStep step;
    passNumbers(numbers, step);
    step.point.settling.why = numbers.rest();
    return step;
}

}  // namespace

std::vector<SweepPoint> sweepThrough(const SweepRange& range, const Network* several,
                                     const Bar& bar, const std::vector<SweepDirection>& directions,
                                     Journal* journal, std::int64_t threads, SweepControl control)
{
    if (journal != nullptr) {
        for (const std::string& line : journal->known()) {
            control.known.push_back(sweepStepOf(line));
        }
        control.keep = [journal](const SweepStep& step) { journal->add(lineOf(step)); };
    }
    control.share = [threads](std::size_t count, const auto& serve) {
        shareWork(count, threads, serve, {});
    };
    if (several == nullptr) {
        return sweep(range, directions, control);
    }
    const NetworkSweep of{*several, bar, range};
    return sweep(range, of.body(), directions, control);
}

}  // namespace signorini
