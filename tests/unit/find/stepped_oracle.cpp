#include "stepped_oracle.hpp"

#include "cddlib.hpp"

namespace signorini::test {

namespace {

/// A linear function of the 2N unknowns, with a constant.
using Form = RationalVector;

Form operator*(const Rational& factor, Form form)
{
    for (Rational& value : form) {
        value *= factor;
    }
    return form;
}

Form operator+(Form one, const Form& other)
{
    for (std::size_t k = 0; k < one.size(); ++k) {
        one[k] += other[k];
    }
    return one;
}

class ExactCells {
public:
    explicit ExactCells(const std::vector<ExactSegment>& parts) : parts_(parts)
    {
        for (const ExactSegment& part : parts) {
            cells_ += static_cast<std::size_t>(part.cells);
        }
        for (std::size_t k = 0; k < 2 * cells_; ++k) {
            Form form(2 * cells_ + 1);
            form[k] = 1;
            (k < cells_ ? a_ : b_).push_back(form);
        }
    }

    [[nodiscard]] const Form& arriving() const { return a_.back(); }

    /// N u(L).
    [[nodiscard]] Form stretch() const
    {
        Form sum(2 * cells_ + 1);
        for (std::size_t k = 0; k < cells_; ++k) {
            sum = sum + b_[k] + Rational(-1) * a_[k];
        }
        return sum;
    }

    void step(bool isHeld)
    {
        std::vector<Form> a(cells_);
        std::vector<Form> b(cells_);
        a[0] = Rational(-1) * b_[0];
        b[cells_ - 1] = Rational(isHeld ? -1 : 1) * a_[cells_ - 1];
        std::size_t end = 0;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const std::size_t first = end;
            end += static_cast<std::size_t>(parts_[i].cells);
            for (std::size_t k = first; k + 1 < end; ++k) {
                a[k + 1] = a_[k];
                b[k] = b_[k + 1];
            }
            if (i + 1 < parts_.size()) {
                const Rational left = parts_[i].impedance();
                const Rational right = parts_[i + 1].impedance();
                const Rational all = left + right + Rational(parts_[i].dashpot, 10);
                const Form v = (2 * left / all) * a_[end - 1] + (2 * right / all) * b_[end];
                b[end - 1] = v + Rational(-1) * a_[end - 1];
                a[end] = v + Rational(-1) * b_[end];
            }
        }
        a_ = std::move(a);
        b_ = std::move(b);
    }

    /// What a period has changed, in rows.
    [[nodiscard]] std::vector<Form> change() const
    {
        std::vector<Form> rows;
        for (std::size_t k = 0; k < 2 * cells_; ++k) {
            rows.push_back(k < cells_ ? a_[k] : b_[k - cells_]);
            rows.back()[k] -= 1;
        }
        return rows;
    }

    [[nodiscard]] std::size_t unknowns() const { return 2 * cells_; }
    [[nodiscard]] Rational cells() const { return static_cast<std::int64_t>(cells_); }

private:
    std::vector<ExactSegment> parts_;
    std::size_t cells_ = 0;
    std::vector<Form> a_;
    std::vector<Form> b_;
};

/// form >= 0, or = 0.
struct Row {
    Form form;
    bool isEquality;
};

bool isFeasible(const std::vector<Row>& rows, std::size_t unknowns)
{
    const CddMatrix matrix = cddRows(rows.size(), unknowns);
    matrix->objective = dd_LPmax;
    const auto put = [](mpq_t& to, const Rational& value) {
        REQUIRE(mpq_set_str(to, value.str().c_str(), 10) == 0);
    };
    for (std::size_t k = 0; k < rows.size(); ++k) {
        put(matrix->matrix[k][0], rows[k].form[unknowns]);
        for (std::size_t i = 0; i < unknowns; ++i) {
            put(matrix->matrix[k][i + 1], rows[k].form[i]);
        }
        if (rows[k].isEquality) {
            set_addelem(matrix->linset, static_cast<long>(k) + 1);
        }
    }
    dd_ErrorType error = dd_NoError;
    const std::unique_ptr<dd_LPType, DeleteCdd> program(dd_Matrix2LP(matrix.get(), &error));
    REQUIRE(error == dd_NoError);
    REQUIRE(dd_LPSolve(program.get(), dd_DualSimplex, &error));
    REQUIRE(error == dd_NoError);
    return program->LPS == dd_Optimal;
}

}  // namespace

std::vector<Segment> segmentsOf(const std::vector<ExactSegment>& parts)
{
    std::vector<Segment> segments;
    const Rational unit = parts.front().impedance();
    for (const ExactSegment& part : parts) {
        segments.push_back({.cells = part.cells,
                            .impedance = static_cast<double>(Rational(part.impedance() / unit)),
                            .dashpot = static_cast<double>(Rational(part.dashpot, 10) / unit)});
    }
    return segments;
}

std::int64_t kernelDimension(const std::vector<ExactSegment>& parts, const Schedule& schedule)
{
    ExactCells cells(parts);
    for (const Phase& phase : schedule.phases) {
        for (std::int64_t step = 0; step < phase.contact + phase.free; ++step) {
            cells.step(step < phase.contact);
        }
    }
    std::vector<RationalVector> rows = cells.change();
    std::int64_t free = 0;
    // Each null vector fixes one more unknown, until none is left.
    while (const auto vector = nullVector(rows, cells.unknowns())) {
        RationalVector row(cells.unknowns() + 1);
        for (std::size_t k = 0; k < vector->size(); ++k) {
            row[k] = (*vector)[k];
        }
        rows.push_back(std::move(row));
        ++free;
    }
    return free;
}

bool exists(const std::vector<ExactSegment>& parts, const Schedule& schedule)
{
    ExactCells cells(parts);
    const std::size_t one = cells.unknowns();
    std::vector<Row> rows;
    const Rational right = cells.cells() * schedule.stops.right;
    Rational left = 0;
    if (schedule.stops.left) {
        left = -cells.cells() *
               Rational(schedule.stops.left->numerator, schedule.stops.left->denominator);
    }
    Form place = cells.stretch();
    for (const Phase& phase : schedule.phases) {
        const bool isRight = phase.stop == Stop::right;
        Form start = place;
        start[one] -= isRight ? right : left;
        rows.push_back({start, true});
        for (std::int64_t step = 0; step < phase.contact; ++step) {
            rows.push_back({Rational(isRight ? 1 : -1) * cells.arriving(), false});
            cells.step(true);
        }
        for (std::int64_t step = 0; step < phase.free; ++step) {
            place = place + Rational(2) * cells.arriving();
            Form below = Rational(-1) * place;
            below[one] += right;
            rows.push_back({below, false});
            if (schedule.stops.left) {
                Form above = place;
                above[one] -= left;
                rows.push_back({above, false});
            }
            cells.step(false);
        }
    }
    for (Form& row : cells.change()) {
        rows.push_back({std::move(row), true});
    }
    return isFeasible(rows, one);
}

}  // namespace signorini::test
