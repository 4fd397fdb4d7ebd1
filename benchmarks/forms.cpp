#include "forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "formulation.hpp"
#include "signorini/lumped_set.hpp"

namespace signorini::bench {

namespace {

constexpr std::array forms{
    Form{.name = "sd", .isDense = true},
    Form{.name = "sd-redundant", .isDense = true, .hasRedundant = true},
    Form{.name = "paper", .isDense = true, .hasRedundant = true, .hasAllCells = true},
    Form{.name = "sy"},
    Form{.name = "dy", .unknowns = Unknowns::delay},
    Form{.name = "ky", .unknowns = Unknowns::amplitudes},
    Form{.name = "kd", .unknowns = Unknowns::amplitudes, .isDense = true},
};

/// Rows of a sparse matrix, one after the other.
struct Rows {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> rhs;

    void add(const std::map<Eigen::Index, double>& row, double value)
    {
        for (const auto& [column, factor] : row) {
            if (factor != 0.0) {
                entries.emplace_back(static_cast<int>(rhs.size()), static_cast<int>(column),
                                     factor);
            }
        }
        rhs.push_back(value);
    }

    void add(const Eigen::VectorXd& row, double value)
    {
        for (Eigen::Index column = 0; column < row.size(); ++column) {
            // What sums of 1/N leave of a zero is rounding.
            if (std::abs(row[column]) > 1e-9) {
                entries.emplace_back(static_cast<int>(rhs.size()), static_cast<int>(column),
                                     row[column]);
            }
        }
        rhs.push_back(value);
    }

    void moveTo(Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix, Eigen::VectorXd& values,
                Eigen::Index columns) const
    {
        matrix.resize(static_cast<Eigen::Index>(rhs.size()), columns);
        matrix.setFromTriplets(entries.begin(), entries.end());
        values =
            Eigen::Map<const Eigen::VectorXd>(rhs.data(), static_cast<Eigen::Index>(rhs.size()));
    }
};

/// In every form p_m is one unknown times +1, -1 or 0: `delay_[m]`.
class Builder {
public:
    Builder(const Schedule& schedule, const Form& form, const Demands& demands, const Kept& kept)
        : form_(form), demands_(demands), kept_(kept), schedule_(schedule)
    {
        if (!kept.longPhases) {
            fold(schedule_);
        }
        for (const Phase& phase : schedule_.phases) {
            isHeld_.insert(isHeld_.end(), static_cast<std::size_t>(phase.contact), true);
            isHeld_.insert(isHeld_.end(), static_cast<std::size_t>(phase.free), false);
        }
        steps_ = static_cast<std::int64_t>(isHeld_.size());
        chooseUnknowns();
    }

    Formulated build()
    {
        columns_ = std::max<Eigen::Index>(motionColumns_, 1);
        addPeriodicity();
        addGap();
        addPressure();
        addFlights();
        if (kept_.strainRows) {
            addStrainRows();
        }
        Formulated result;
        result.schedule = schedule_;
        result.program = emptyProgram(columns_);
        equal_.moveTo(result.program.equalities, result.program.equalityRhs, columns_);
        below_.moveTo(result.program.inequalities, result.program.inequalityRhs, columns_);
        const Eigen::Index chained = columns_ - std::max<Eigen::Index>(motionColumns_, 1);
        result.program.upper.tail(chained).setZero();
        delay_.resize(static_cast<std::size_t>(steps_));
        result.delay = std::move(delay_);
        return result;
    }

private:
    using Row = std::map<Eigen::Index, double>;

    void chooseUnknowns()
    {
        const std::int64_t cells = schedule_.cells;
        switch (form_.unknowns) {
            case Unknowns::waves:
                motionColumns_ = 2 * cells;
                for (std::int64_t m = 0; m < cells; ++m) {
                    delay_.push_back({cells - 1 - m, 1.0});
                }
                for (std::int64_t m = 0; m < cells; ++m) {
                    delay_.push_back({cells + m, -1.0});
                }
                for (std::int64_t m = 0; m < steps_; ++m) {
                    DelayTerm term = delay_[static_cast<std::size_t>(m)];
                    term.factor *= isHeld_[static_cast<std::size_t>(m)] ? 1.0 : -1.0;
                    delay_.push_back(term);
                }
                break;
            case Unknowns::delay:
                motionColumns_ = steps_;
                for (std::int64_t m = 0; m < steps_; ++m) {
                    delay_.push_back({m, 1.0});
                }
                break;
            case Unknowns::amplitudes:
                chooseAmplitudes();
                break;
        }
    }

    void chooseAmplitudes()
    {
        const ClassTypes classes = classTypes(schedule_);
        std::vector<Eigen::Index> first;
        for (const ClassType& type : classes.types) {
            first.push_back(motionColumns_);
            motionColumns_ += type.kind == TypeKind::dead ? 0 : type.count;
        }
        for (std::int64_t alpha = 0; alpha < classes.members; ++alpha) {
            for (std::size_t t = 0; t < classes.types.size(); ++t) {
                const ClassType& type = classes.types[t];
                for (std::int64_t j = 0; j < type.count; ++j) {
                    delay_.push_back(
                        type.kind == TypeKind::dead
                            ? DelayTerm{}
                            : DelayTerm{first[t] + j,
                                        static_cast<double>(
                                            type.signs[static_cast<std::size_t>(alpha)])});
                }
            }
        }
    }

    /// p_m as it enters a row, times a factor. Waves know p up to m = n + 2N, the others are
    /// periodic by their unknowns.
    void addWave(Row& row, std::int64_t m, double factor) const
    {
        const auto known = static_cast<std::int64_t>(delay_.size());
        const DelayTerm& term = delay_[static_cast<std::size_t>(m < known ? m : m % steps_)];
        row[term.column] += factor * term.factor;
    }

    /// (30).
    void addPeriodicity()
    {
        const std::int64_t window = 2 * schedule_.cells;
        if (form_.unknowns == Unknowns::waves) {
            for (std::int64_t m = 0; m < window; ++m) {
                Row row;
                addWave(row, steps_ + m, 1.0);
                addWave(row, m, -1.0);
                equal_.add(row, 0.0);
            }
        } else if (form_.unknowns == Unknowns::delay) {
            for (std::int64_t m = 0; m < steps_; ++m) {
                Row row;
                addWave(row, m + window, 1.0);
                addWave(row, m, isHeld_[static_cast<std::size_t>(m)] ? -1.0 : 1.0);
                equal_.add(row, 0.0);
            }
        }
    }

    /// (31).
    void addGap()
    {
        Row row;
        for (std::int64_t m = 0; m < 2 * schedule_.cells; ++m) {
            addWave(row, m, 1.0);
        }
        equal_.add(row, -static_cast<double>(schedule_.stops.right * schedule_.cells));
    }

    /// (10).
    void addPressure()
    {
        const std::int64_t copies = form_.hasAllCells ? schedule_.cells : 1;
        for (std::int64_t m = 0; m < steps_; ++m) {
            for (std::int64_t k = 0; isHeld_[static_cast<std::size_t>(m)] && k < copies; ++k) {
                Row row;
                addWave(row, m, -1.0);
                below_.add(row, 0.0);
            }
        }
    }

    /// (11), (12), and what closes every flight.
    void addFlights()
    {
        std::int64_t m = 0;
        for (std::size_t k = 0; k < schedule_.phases.size(); ++k) {
            m += schedule_.phases[k].contact;
            const bool closes = form_.hasRedundant || k + 1 < schedule_.phases.size();
            if (form_.isDense) {
                addDenseFlight(m, schedule_.phases[k].free, closes);
            } else {
                addChainedFlight(m, schedule_.phases[k].free, closes);
            }
            m += schedule_.phases[k].free;
        }
    }

    void addDenseFlight(std::int64_t first, std::int64_t count, bool closes)
    {
        const std::int64_t instants = form_.hasAllCells ? schedule_.cells : 1;
        if (form_.hasRedundant) {
            for (std::int64_t k = 0; k < instants; ++k) {
                Row row;
                addWave(row, first, 1.0);
                below_.add(row, 0.0);
            }
        }
        Eigen::VectorXd prefix = Eigen::VectorXd::Zero(columns_);
        for (std::int64_t m = first; m < first + count; ++m) {
            const DelayTerm& term = delay_[static_cast<std::size_t>(m)];
            for (std::int64_t k = 1; k <= instants; ++k) {
                prefix[term.column] += term.factor / static_cast<double>(instants);
                below_.add(prefix, 0.0);
            }
        }
        if (closes) {
            equal_.add(prefix, 0.0);
        }
    }

    void addChainedFlight(std::int64_t first, std::int64_t count, bool closes)
    {
        for (std::int64_t m = first; m < first + count; ++m) {
            Row row{{columns_, 1.0}};
            if (m > first) {
                row[columns_ - 1] = -1.0;
            }
            addWave(row, m, -1.0);
            equal_.add(row, 0.0);
            ++columns_;
        }
        if (closes) {
            equal_.add(Row{{columns_ - 1, 1.0}}, 0.0);
        }
    }

    /// -s = p_k + p_l <= S for each step m and each pair that meets in a cell during it,
    /// k + l = 2(m + N) - 1, |k - l| odd and < 2N; the clamp, where p counts twice, last.
    void addStrainRows()
    {
        const std::int64_t cells = schedule_.cells;
        for (std::int64_t m = 0; m < steps_; ++m) {
            for (std::int64_t apart = 1; apart < 2 * cells; apart += 2) {
                const std::int64_t low = m + cells - (apart + 1) / 2;
                Row row;
                addWave(row, low % steps_, 1.0);
                addWave(row, (low + apart) % steps_, 1.0);
                below_.add(row, demands_.strainLimit);
            }
            Row atClamp;
            addWave(atClamp, m, 2.0);
            below_.add(atClamp, demands_.strainLimit);
        }
    }

    const Form& form_;
    const Demands& demands_;
    Kept kept_;
    Schedule schedule_;
    std::vector<bool> isHeld_;
    std::int64_t steps_ = 0;
    std::vector<DelayTerm> delay_;
    Eigen::Index motionColumns_ = 0;
    Eigen::Index columns_ = 0;
    Rows equal_;
    Rows below_;
};

}  // namespace

const std::vector<std::string_view>& comparedForms()
{
    static const std::vector<std::string_view> names{"sd", "sy", "dy", "ky", "kd"};
    return names;
}

Formulated poseForm(const Schedule& schedule, const Demands& demands, std::string_view form,
                    const Kept& kept)
{
    for (const Formulation own : {Formulation::reduced, Formulation::lumped}) {
        if (form == name(own)) {
            return pose(schedule, demands, own);
        }
    }
    const auto found = std::find_if(forms.begin(), forms.end(),
                                    [form](const Form& known) { return known.name == form; });
    if (found == forms.end()) {
        throw std::invalid_argument(fmt::format("form = {} is unknown", form));
    }
    const bool wantsEnergy = demands.objective == Objective::minEnergy;
    if ((demands.objective != Objective::any && !wantsEnergy) ||
        std::isfinite(demands.strainLimit) != kept.strainRows) {
        throw std::invalid_argument(
            "form: allowed objectives any|min-energy, and a strain limit as rows");
    }
    Formulated result = Builder(schedule, *found, demands, kept).build();
    if (wantsEnergy) {
        result.program.quadratic = 2.0 * energyWeights(result);
    }
    if (demands.energyRatio) {
        result.program.energy = EnergyEquality{energyWeights(result), *demands.energyRatio};
    }
    return result;
}

}  // namespace signorini::bench
