#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "integers.hpp"
#include "signorini/verification.hpp"

namespace signorini {

namespace {

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
            flipped = static_cast<std::int8_t>(-flipped);
            contact(1);
        }
    }

private:
    std::int64_t cells_;
    std::int64_t head_ = 0;
    std::vector<std::int8_t> signs_;
};

/// The coefficients of a combination of rows over the 2N unknowns; \throws std::overflow_error of
/// one that its numbers do not hold.
template <typename Number>
class IntegerRow {
public:
    explicit IntegerRow(std::int64_t size) : values_(static_cast<std::size_t>(size), 0) {}

    void add(std::size_t unknown, std::int64_t coefficient, std::int64_t multiplier)
    {
        const std::int64_t sum =
            checkedAdd(values_[unknown], checkedMultiply(coefficient, multiplier));
        if (!std::in_range<Number>(sum)) {
            throw std::overflow_error("a coefficient of a combination of rows");
        }
        values_[unknown] = static_cast<Number>(sum);
    }

    [[nodiscard]] bool isZero() const
    {
        return std::all_of(values_.begin(), values_.end(), [](auto v) { return v == 0; });
    }

private:
    std::vector<Number> values_;
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
template <typename Number>
void addPenetration(const std::vector<Multiplier>& rows, std::int64_t first, std::int64_t count,
                    SignLine line, IntegerRow<Number>& total)
{
    // Prefix sums repeat after 4N steps of flight; the row at 4N - 1 itself is zero.
    const std::int64_t repeat = 2 * line.size();
    std::vector<Multiplier> ends;
    std::int64_t remaining = 0;
    for (const Multiplier& m : rows) {
        if (m.row >= first && m.row < first + count) {
            ends.push_back({(m.row - first) % repeat, m.value});
            remaining = checkedAdd(remaining, m.value);
        }
    }
    std::sort(ends.begin(), ends.end(),
              [](const Multiplier& one, const Multiplier& other) { return one.row < other.row; });
    // p of step k stands in every prefix row from k on.
    std::int64_t step = 0;
    for (const Multiplier& end : ends) {
        for (; step <= end.row; ++step) {
            total.add(line.unknown(0), line.sign(0), remaining);
            line.free(1);
        }
        remaining -= end.value;
    }
}

/// Is the right side of the combination, gap (b - a) + size p, negative? N > 0 is left out.
bool isNegative(const FarkasCertificate& certificate, const Stops& stops)
{
    if (stops.left) {
        return false;  // rows with other right sides, which certificates do not know
    }
    return stops.right == 0 ? certificate.size < 0
                            : certificate.size == 0 && certificate.gap * stops.right < 0;
}

template <typename Number>
bool combinesToContradiction(const FarkasCertificate& certificate, const Schedule& schedule)
{
    const std::int64_t cells = schedule.cells;
    SignLine line(cells);
    IntegerRow<Number> total(2 * cells);
    for (std::int64_t i = 0; i < cells; ++i) {  // (31): sum(b - a)
        total.add(static_cast<std::size_t>(i), -1, certificate.gap);
        total.add(static_cast<std::size_t>(cells + i), 1, certificate.gap);
    }
    std::int64_t firstContact = 0;
    std::int64_t firstFree = 0;
    for (const Phase& phase : schedule.phases) {
        if (certificate.size != 0) {
            Phase counted = phase;
            fold(cells, counted);
            for (std::int64_t step = 0; step < counted.contact; ++step) {
                total.add(line.unknown(step), line.sign(step), certificate.size);
            }
        }
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
    // (30): x at the end minus x at the start. a_N, ..., a_1, -b_1, ..., -b_N arrive at the tip.
    for (const Multiplier& m : certificate.periodicity) {
        const bool isA = m.row < cells;
        const std::int64_t place = isA ? cells - 1 - m.row : m.row;
        total.add(line.unknown(place), isA ? line.sign(place) : -line.sign(place), m.value);
        total.add(static_cast<std::size_t>(m.row), -1, m.value);
    }
    return total.isZero();
}

}  // namespace

bool isProof(const FarkasCertificate& certificate, const Schedule& schedule)
{
    validate(schedule);
    std::int64_t contactRows = 0;
    std::int64_t freeRows = 0;
    for (const Phase& phase : schedule.phases) {
        contactRows += phase.contact;
        freeRows += phase.free;
    }
    if (!isNegative(certificate, schedule.stops) ||
        !areMultipliers(certificate.periodicity, 2 * schedule.cells, true) ||
        !areMultipliers(certificate.pressure, contactRows, false) ||
        !areMultipliers(certificate.penetration, freeRows, false)) {
        return false;
    }
    try {
        // Multipliers are small but for odd proofs; half the memory is touched.
        return combinesToContradiction<std::int32_t>(certificate, schedule);
    } catch (const std::overflow_error&) {
    }
    try {
        return combinesToContradiction<std::int64_t>(certificate, schedule);
    } catch (const std::overflow_error&) {
        return false;
    }
}

}  // namespace signorini
