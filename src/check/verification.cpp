#include "signorini/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compensated_sum.hpp"
#include "faults.hpp"
#include "integers.hpp"
#include "propagation.hpp"

namespace signorini {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool isFinite(const State& state)
{
    return state.a.allFinite() && state.b.allFinite();
}

/// How far the bar is from a state, relative to that state.
double relativeDistance(const DelayLine& line, const State& state)
{
    const double size = amplitude(state);
    const double distance = line.distance(state);
    return size > 0.0 ? distance / size : distance;
}

/// N (1 - u(L)/g) / 2: how far the tip is from the wall, in units in which a free step with
/// arriving wave p brings it nearer by p.
CompensatedSum openingOf(const State& state)
{
    CompensatedSum opening(0.5 * static_cast<double>(state.cells()));
    for (Eigen::Index i = 0; i < state.a.size(); ++i) {
        opening.add(0.5 * state.a[i]);
        opening.add(-0.5 * state.b[i]);
    }
    return opening;
}

/// Runs of pressed and unpressed steps over one period, as seen from its first step.
class ContactRuns {
public:
    void add(bool pressed, std::int64_t count)
    {
        if (pressed) {
            if (runs_.empty() || runs_.back().free > 0) {
                runs_.push_back({});
            }
            runs_.back().contact += count;
        } else if (runs_.empty()) {
            lead_ += count;
        } else {
            runs_.back().free += count;
        }
    }

    /// The same period from the start of a pressed run.
    [[nodiscard]] std::vector<Phase> phases() const
    {
        std::vector<Phase> result = runs_;
        if (!result.empty()) {
            result.back().free += lead_;
            if (result.back().free == 0 && result.size() > 1) {
                result.front().contact += result.back().contact;
                result.pop_back();
            }
        }
        return result;
    }

private:
    std::int64_t lead_ = 0;
    std::vector<Phase> runs_;
};

/// The 2N unknowns as seen by the tip, with signs only: which unknown arrives, and how often it
/// has been negated. Independent of the code that constructs certificates.
class SignLine {
public:
    explicit SignLine(std::int64_t cells)
        : cells_(cells), signs_(static_cast<std::size_t>(2 * cells), 1)
    {
    }

    [[nodiscard]] std::int64_t size() const { return 2 * cells_; }

    /// Index of the m-th arriving value among the unknowns (a, b), and its sign: the initial state
    /// sends a_N, ..., a_1 and then -b_1, ..., -b_N to the tip.
    [[nodiscard]] std::size_t unknown(std::int64_t m) const
    {
        const std::int64_t k = (head_ + m) % size();
        return static_cast<std::size_t>(k < cells_ ? cells_ - 1 - k : k);
    }

    [[nodiscard]] std::int64_t sign(std::int64_t m) const
    {
        const std::int64_t k = (head_ + m) % size();
        const std::int64_t sign = signs_[static_cast<std::size_t>(k)];
        return k < cells_ ? sign : -sign;
    }

    void contact(std::int64_t count) { head_ = (head_ + count % size()) % size(); }

    void free(std::int64_t count)
    {
        for (std::int64_t step = count % (2 * size()); step > 0; --step) {
            auto& flipped = signs_[static_cast<std::size_t>(head_)];
            flipped = -flipped;
            contact(1);
        }
    }

private:
    std::int64_t cells_;
    std::int64_t head_ = 0;
    std::vector<std::int32_t> signs_;
};

/// The coefficients of a combination of rows over the 2N unknowns.
class IntegerRow {
public:
    explicit IntegerRow(std::int64_t size) : values_(static_cast<std::size_t>(size), 0) {}

    void add(std::size_t unknown, std::int64_t coefficient, std::int64_t multiplier)
    {
        values_[unknown] = checkedAdd(values_[unknown], checkedMultiply(coefficient, multiplier));
    }

    [[nodiscard]] bool isZero() const
    {
        return std::all_of(values_.begin(), values_.end(), [](auto v) { return v == 0; });
    }

private:
    std::vector<std::int64_t> values_;
};

bool areMultipliers(const std::vector<Multiplier>& rows, std::int64_t rowCount, bool signedRows)
{
    std::int64_t previous = -1;
    return std::all_of(rows.begin(), rows.end(), [&](const Multiplier& m) {
        const bool fine = m.row > previous && m.row < rowCount && (signedRows || m.value >= 0);
        previous = m.row;
        return fine;
    });
}

/// Adds the rows (12) of one phase, `first` being the number of its first row.
void addPenetration(const std::vector<Multiplier>& rows, std::int64_t first, std::int64_t count,
                    SignLine line, IntegerRow& total)
{
    const auto inPhase = [&](const Multiplier& m) {
        return m.row >= first && m.row < first + count;
    };
    if (std::none_of(rows.begin(), rows.end(), inPhase)) {
        return;
    }
    // Prefix sums repeat after 4N steps of flight; the row at 4N - 1 itself is zero.
    const std::int64_t repeat = 2 * line.size();
    std::vector<std::int64_t> weight(static_cast<std::size_t>(std::min(count, repeat)), 0);
    for (const Multiplier& m : rows) {
        if (inPhase(m)) {
            auto& entry = weight[static_cast<std::size_t>((m.row - first) % repeat)];
            entry = checkedAdd(entry, m.value);
        }
    }
    // p of step k stands in every prefix row from k on.
    std::int64_t remaining = 0;
    for (const std::int64_t w : weight) {
        remaining = checkedAdd(remaining, w);
    }
    for (const std::int64_t w : weight) {
        if (remaining == 0) {
            break;
        }
        total.add(line.unknown(0), line.sign(0), remaining);
        remaining -= w;
        line.free(1);
    }
}

bool combinesToContradiction(const FarkasCertificate& certificate, const Schedule& schedule)
{
    const std::int64_t cells = schedule.cells;
    SignLine line(cells);
    IntegerRow total(2 * cells);
    for (std::int64_t i = 0; i < cells; ++i) {  // (31): sum(b - a)
        total.add(static_cast<std::size_t>(i), -1, certificate.gap);
        total.add(static_cast<std::size_t>(cells + i), 1, certificate.gap);
    }
    std::int64_t firstContact = 0;
    std::int64_t firstFree = 0;
    for (const Phase& phase : schedule.phases) {
        for (const Multiplier& m : certificate.pressure) {  // (10): -p_m
            if (m.row >= firstContact && m.row < firstContact + phase.contact) {
                const std::int64_t step = m.row - firstContact;
                total.add(line.unknown(step), -line.sign(step), m.value);
            }
        }
        line.contact(phase.contact);
        addPenetration(certificate.penetration, firstFree, phase.free, line, total);
        line.free(phase.free);
        firstContact += phase.contact;
        firstFree += phase.free;
    }
    // (30): x at the end minus x at the start, row by row in the order of arrival at the tip.
    const SignLine start(cells);
    std::vector<std::int64_t> y(static_cast<std::size_t>(2 * cells), 0);
    for (const Multiplier& m : certificate.periodicity) {
        y[static_cast<std::size_t>(m.row)] = m.value;
    }
    for (std::int64_t m = 0; m < 2 * cells; ++m) {
        const std::size_t row = start.unknown(m);
        total.add(line.unknown(m), start.sign(m) * line.sign(m), y[row]);
        total.add(row, -1, y[row]);
    }
    return total.isZero();
}

/// (30)-(32) along the schedule, and which of its phases press; the march is left at 0.
Residuals residualsOfRows(const State& state, Schedule schedule, double tolerance,
                          std::vector<bool>& pressing)
{
    fold(schedule);
    DelayLine line(state);
    const double size = amplitude(state);
    const double halfCells = 0.5 * static_cast<double>(state.cells());
    CompensatedSum opening = openingOf(state);
    double tension = 0.0;
    double deepest = 0.0;
    double misplaced = 0.0;
    for (const Phase& phase : schedule.phases) {
        misplaced = std::max(misplaced, std::abs(opening.value()));
        double push = 0.0;
        for (std::int64_t step = 0; step < phase.contact; ++step) {
            tension = std::max(tension, -line.incoming());
            push = std::max(push, line.incoming());
            line.contactStep();
        }
        pressing.push_back(push > tolerance * size);
        CompensatedSum prefix;
        for (std::int64_t step = 0; step < phase.free; ++step) {
            prefix.add(line.incoming());
            deepest = std::max(deepest, prefix.value());
            line.freeStep();
        }
        opening.add(-prefix.value());
    }
    return {.periodicity = relativeDistance(line, state),
            .gap = misplaced / halfCells,
            .pressure = size > 0.0 ? tension / size : tension,
            .penetration = deepest / halfCells};
}

/// Is the list one shorter list, `times` over?
bool repeats(const std::vector<Phase>& phases, std::size_t times)
{
    const std::size_t length = phases.size() / times;
    return phases.size() % times == 0 &&
           std::equal(phases.begin() + static_cast<std::ptrdiff_t>(length), phases.end(),
                      phases.begin());
}

/// Two equal phases may be one motion twice: shortens the canonical list to the shortest period
/// that the list suggests and a march confirms.
void findPrimitivePeriod(const State& state, std::int64_t count, double tolerance,
                         Verification& result)
{
    for (std::size_t times = result.canonical.size(); times > 1; --times) {
        const auto divisor = static_cast<std::int64_t>(times);
        if (count % divisor == 0 && repeats(result.canonical, times) &&
            march(state, count / divisor, tolerance).residual <= tolerance) {
            result.canonical.resize(result.canonical.size() / times);
            result.repetitions = divisor;
            return;
        }
    }
}

}  // namespace

March march(const State& state, std::int64_t count, double tolerance)
{
    if (count < 0) {
        throw std::invalid_argument(fmt::format("count = {} is out of range: allowed >= 0", count));
    }
    DelayLine line(state);
    March result;
    if (!isFinite(state)) {
        result.residual = infinity;
        return result;
    }
    const double size = amplitude(state);
    const double halfCells = 0.5 * static_cast<double>(state.cells());
    const double atWall = tolerance * halfCells;
    CompensatedSum opening = openingOf(state);
    ContactRuns runs;

    const std::int64_t repeat = 4 * state.cells();
    std::int64_t flight = 0;
    for (std::int64_t step = 0; step < count; ++step) {
        const double p = line.incoming();
        const double room = opening.value();
        const bool wouldPass = p > 0.0 && p > room;
        // Rounding may make p exceed the room of a tip that lands just now: it is at the wall
        // before the step only if that is nearer than landing.
        if (wouldPass && room <= atWall && room < 0.5 * p) {
            runs.add(p > tolerance * size, 1);
            line.contactStep();
            flight = 0;
            continue;
        }
        if (wouldPass && p - room > atWall) {
            result.firstFault = step;
            result.residual = (p - room) / halfCells;
            return result;
        }
        opening.add(-p);
        runs.add(false, 1);
        line.freeStep();
        if (++flight == repeat) {
            // Back in the state of 4N steps ago: whole further repeats change nothing.
            const std::int64_t skipped = (count - step - 1) / repeat * repeat;
            if (skipped > 0) {
                runs.add(false, skipped);
            }
            count -= skipped;
        }
    }
    result.residual = relativeDistance(line, state);
    result.phases = runs.phases();
    return result;
}

double Residuals::worst() const
{
    return std::max({periodicity, gap, pressure, penetration, march, demands});
}

Verification verify(const State& state, const Schedule& schedule, double tolerance)
{
    validate(schedule);
    if (state.cells() != schedule.cells) {
        throw std::invalid_argument(fmt::format("state: {} cells: allowed {}, as in the schedule",
                                                state.cells(), schedule.cells));
    }
    if (!isFinite(state)) {
        return {{infinity, infinity, infinity, infinity, infinity, infinity}, {}, 1, {}};
    }
    Verification result;
    result.residuals = residualsOfRows(state, schedule, tolerance, result.pressing);
    March seen = march(state, steps(schedule), tolerance);
    result.residuals.march = seen.residual;
    result.canonical = std::move(seen.phases);
    findPrimitivePeriod(state, steps(schedule), tolerance, result);
    return result;
}

bool isProof(const FarkasCertificate& certificate, const Schedule& schedule)
{
    validate(schedule);
    std::int64_t contactRows = 0;
    std::int64_t freeRows = 0;
    for (const Phase& phase : schedule.phases) {
        contactRows += phase.contact;
        freeRows += phase.free;
    }
    if (certificate.gap >= 0 ||
        !areMultipliers(certificate.periodicity, 2 * schedule.cells, true) ||
        !areMultipliers(certificate.pressure, contactRows, false) ||
        !areMultipliers(certificate.penetration, freeRows, false)) {
        return false;
    }
    try {
        return combinesToContradiction(certificate, schedule);
    } catch (const std::overflow_error&) {
        return false;
    }
}

}  // namespace signorini
