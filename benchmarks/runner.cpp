#include "runner.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <set>
#include <system_error>

#include "signorini/output.hpp"
#include "solver.hpp"

namespace signorini::bench {

namespace {

using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;

void noteSignal(int)
{
    interrupted = 1;
}

/// Fills the record in the child; exceptions are outcomes.
void measure(const Case& work, Record& record)
{
    try {
        work.body(record);
    } catch (const BackendUnavailable& error) {
        record.outcome = "absent";
        record.detail = error.what();
    } catch (const std::bad_alloc&) {
        record.outcome = "memory";
        record.detail = "std::bad_alloc at the limit";
    } catch (const std::invalid_argument& error) {
        record.outcome = "refused";
        record.detail = error.what();
    } catch (const std::exception& error) {
        record.outcome = "undecided";
        record.detail = error.what();
    }
}

/// The life of the child: never returns.
[[noreturn]] void runChild(const Case& work, const Limits& limits, int pipeEnd)
{
    setpgid(0, 0);  // with all it starts, it can be ended as one
    (void)std::signal(SIGINT, SIG_DFL);
    (void)std::signal(SIGTERM, SIG_DFL);
    const auto bytes = static_cast<rlim_t>(limits.megabytes * 1e6);
    const rlimit memory{bytes, bytes};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    const int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(null, STDOUT_FILENO);  // libraries talk
    dup2(null, STDERR_FILENO);
    Record record = work.record;
    measure(work, record);
    const std::string line = csvLine(record);
    std::size_t sent = 0;
    while (sent < line.size()) {
        const ssize_t count = write(pipeEnd, line.data() + sent, line.size() - sent);
        if (count < 0) {
            _exit(1);
        }
        sent += static_cast<std::size_t>(count);
    }
    _exit(0);
}

/// Reads until the other end closes or the time is up; true if it closed.
bool readAll(int pipeEnd, double seconds, std::string& text)
{
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
    std::array<char, 4096> buffer{};
    while (!isInterrupted()) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        if (left <= 0) {
            return false;
        }
        pollfd waiting{pipeEnd, POLLIN, 0};
        if (poll(&waiting, 1, static_cast<int>(left)) <= 0) {
            continue;
        }
        const ssize_t count = read(pipeEnd, buffer.data(), buffer.size());
        if (count == 0) {
            return true;
        }
        if (count > 0) {
            text.append(buffer.data(), static_cast<std::size_t>(count));
        }
    }
    return false;
}

[[noreturn]] void failSystem(const char* what)
{
    throw std::system_error(errno, std::generic_category(), what);
}

bool wasEndedByLimit(const Record& record)
{
    return record.outcome == "timeout" || record.outcome == "memory" ||
           record.outcome == "crashed" || record.outcome == "skipped";
}

/// Writes one line of progress over the last one.
void showProgress(std::size_t number, std::size_t count, const std::string& key)
{
    if (isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "\r\033[K[{}/{}] {:.90}", number, count, key);
    }
}

/// A table that is appended to: every row is on its way to the disk before the next case starts.
class TableFile {
public:
    explicit TableFile(const std::string& path) : path_(path)
    {
        // A row cut short by the end of an earlier run must not be continued.
        const bool isNew = !std::filesystem::exists(path) || std::filesystem::file_size(path) == 0;
        bool isWhole = true;
        if (!isNew) {
            std::ifstream old(path, std::ios::binary);
            old.seekg(-1, std::ios::end);
            isWhole = old.get() == '\n';
        }
        file_.open(path, std::ios::app | std::ios::binary);
        if (isNew) {
            append(csvHeader());
        } else if (!isWhole) {
            append("");
        }
    }

    void append(const std::string& line)
    {
        file_ << line << '\n' << std::flush;
        if (!file_) {
            throw FileError(path_, fmt::format("cannot write: {}", std::strerror(errno)));
        }
    }

private:
    std::string path_;
    std::ofstream file_;
};

}  // namespace

void catchInterrupts()
{
    struct sigaction action = {};
    action.sa_handler = noteSignal;  // without SA_RESTART: waiting ends
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool isInterrupted()
{
    return interrupted != 0;
}

std::optional<Record> execute(const Case& work, const Limits& limits)
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        failSystem("pipe");
    }
    const auto start = Clock::now();
    const pid_t child = fork();
    if (child < 0) {
        failSystem("fork");
    }
    if (child == 0) {
        close(ends[0]);
        runChild(work, limits, ends[1]);
    }
    close(ends[1]);
    setpgid(child, child);  // whichever of the two comes first
    std::string text;
    const bool finished = readAll(ends[0], limits.seconds, text);
    close(ends[0]);
    kill(-child, SIGKILL);
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    if (isInterrupted()) {
        return std::nullopt;
    }
    Record record = work.record;
    if (std::optional<Record> answer = parseCsvLine(text)) {
        record = std::move(*answer);
    } else if (!finished) {
        record.outcome = "timeout";
        record.detail = fmt::format("ended after {} s", limits.seconds);
    } else {
        record.outcome = "crashed";
        record.detail = WIFSIGNALED(status)
                            ? fmt::format("ended by signal {} ({})", WTERMSIG(status),
                                          strsignal(WTERMSIG(status)))
                            : fmt::format("exit status {}", WEXITSTATUS(status));
    }
    record.figures["case_seconds"] = std::chrono::duration<double>(Clock::now() - start).count();
    record.figures["peak_megabytes"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
    return record;
}

RunSummary run(const std::vector<Case>& cases, const Limits& limits, const std::string& provenance,
               const std::string& path)
{
    std::map<std::string, Record> known;
    for (Record& record : readTable(path)) {
        if (record.provenance == provenance) {
            std::string key = keyOf(record);
            known.insert_or_assign(std::move(key), std::move(record));
        }
    }
    TableFile table(path);
    RunSummary summary;
    std::set<std::string> endedSeries;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Case& work = cases[i];
        const std::string key = keyOf(work.record);
        std::optional<Record> record;
        if (const auto found = known.find(key); found != known.end()) {
            record = found->second;
            ++summary.kept;
        } else {
            showProgress(i + 1, cases.size(), key);
            if (endedSeries.contains(work.series)) {
                record = work.record;
                record->outcome = "skipped";
                record->detail = "an easier case of this series was ended by a limit";
            } else {
                record = execute(work, limits);
            }
            if (!record) {
                summary.wasInterrupted = true;
                break;
            }
            record->provenance = provenance;
            table.append(csvLine(*record));
            ++summary.done;
        }
        if (!work.series.empty() && wasEndedByLimit(*record)) {
            endedSeries.insert(work.series);
        }
    }
    showProgress(cases.size(), cases.size(), "done\n");
    return summary;
}

}  // namespace signorini::bench
