// Motions of bars whose strain stays above a limit, against linear programs written down here.

#include <glpk.h>

#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "catch.hpp"
#include "energy_floor.hpp"
#include "network_find.hpp"
#include "scene_words.hpp"
#include "signorini/find_periodic.hpp"

using namespace signorini;

namespace {

using Form = std::vector<double>;  ///< of the waves at the start

Form sum(const Form& x, double a, const Form& y, double b)
{
    Form all(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        all[k] = a * x[k] + b * y[k];
    }
    return all;
}

/// Two bars between clamps that meet at a gap, cell by cell: the smallest limit on compression that
/// motions of a schedule can keep, from all pairs of waves that are in one place, in whole steps
/// and halfway between them.
class TwoBars {
public:
    TwoBars(std::size_t left, std::size_t right, double impedance, double speed, double gap)
        : size_(2 * (left + right)), impedance_(impedance), gap_(gap)
    {
        speeds_ = {1.0, speed};
        std::size_t next = 0;
        for (const std::size_t cells : {left, right}) {
            auto& [rightward, leftward] = bars_.emplace_back();
            for (auto* line : {&rightward, &leftward}) {
                for (std::size_t k = 0; k < cells; ++k) {
                    line->push_back(unit(next++));
                }
            }
        }
    }

    std::optional<double> leastLimit(std::int64_t contact, std::int64_t free)
    {
        const auto start = bars_;
        program_ = glp_create_prob();
        glp_add_cols(program_, static_cast<int>(size_) + 1);
        for (std::size_t k = 1; k <= size_; ++k) {
            glp_set_col_bnds(program_, static_cast<int>(k), GLP_FR, 0.0, 0.0);
        }
        glp_set_col_bnds(program_, static_cast<int>(size_) + 1, GLP_LO, 0.0, 0.0);
        glp_set_obj_coef(program_, static_cast<int>(size_) + 1, 1.0);
        add(distance(), GLP_FX, -gap_);
        for (std::int64_t m = 0; m < contact + free; ++m) {
            if (m > contact) {
                add(distance(), GLP_LO, -gap_);
            }
            addStrains();
            step(m < contact);
        }
        for (std::size_t bar = 0; bar < 2; ++bar) {
            for (std::size_t k = 0; k < start[bar].first.size(); ++k) {
                add(sum(bars_[bar].first[k], 1.0, start[bar].first[k], -1.0), GLP_FX, 0.0);
                add(sum(bars_[bar].second[k], 1.0, start[bar].second[k], -1.0), GLP_FX, 0.0);
            }
        }
        glp_smcp settings;
        glp_init_smcp(&settings);
        settings.msg_lev = GLP_MSG_OFF;
        const bool isSolved =
            glp_simplex(program_, &settings) == 0 && glp_get_status(program_) == GLP_OPT;
        const double least = glp_get_obj_val(program_);
        glp_delete_prob(program_);
        bars_ = start;
        return isSolved ? std::optional(least) : std::nullopt;
    }

private:
    [[nodiscard]] Form unit(std::size_t k) const
    {
        Form form(size_, 0.0);
        form[k] = 1.0;
        return form;
    }

    /// u of the right bar's end less that of the left one's, from the clamps.
    [[nodiscard]] Form distance() const
    {
        Form all(size_, 0.0);
        for (const auto& [rightward, leftward] : bars_) {
            for (std::size_t k = 0; k < rightward.size(); ++k) {
                all = sum(all, 1.0, sum(leftward[k], -1.0, rightward[k], 1.0), 1.0);
            }
        }
        return all;
    }

    void step(bool isClosed)
    {
        auto& [right1, left1] = bars_[0];
        auto& [right2, left2] = bars_[1];
        const Form from1 = right1.back();
        const Form from2 = left2.front();
        Form into1 = from1;
        Form into2 = from2;
        if (isClosed) {
            const double whole = 1.0 + impedance_;
            const Form v = sum(from1, 2.0 / whole, from2, 2.0 * impedance_ / whole);
            into1 = sum(v, 1.0, from1, -1.0);
            into2 = sum(v, 1.0, from2, -1.0);
            add(sum(from1, 2.0, v, -1.0), GLP_LO, 0.0);  // what the left bar pushes with
        }
        const Form clamp1 = sum(left1.front(), -1.0, left1.front(), 0.0);
        const Form clamp2 = sum(right2.back(), -1.0, right2.back(), 0.0);
        halfway(0, clamp1, into1);
        halfway(1, into2, clamp2);
        right1.pop_back();
        right1.push_front(clamp1);
        left1.pop_front();
        left1.push_back(into1);
        right2.pop_back();
        right2.push_front(into2);
        left2.pop_front();
        left2.push_back(clamp2);
    }

    void addStrains()
    {
        for (std::size_t bar = 0; bar < 2; ++bar) {
            const auto& [rightward, leftward] = bars_[bar];
            for (std::size_t k = 0; k < rightward.size(); ++k) {
                addStrain(rightward[k], leftward[k], bar);
            }
        }
    }

    /// Between cells k - 1 and k, with what enters at the ends.
    void halfway(std::size_t bar, const Form& onLeft, const Form& onRight)
    {
        const auto& [rightward, leftward] = bars_[bar];
        for (std::size_t k = 0; k <= rightward.size(); ++k) {
            addStrain(k == 0 ? onLeft : rightward[k - 1],
                      k == rightward.size() ? onRight : leftward[k], bar);
        }
    }

    void addStrain(const Form& right, const Form& left, std::size_t bar)
    {
        add(sum(left, 1.0, right, -1.0), GLP_LO, 0.0, speeds_[bar]);
    }

    void add(const Form& form, int kind, double rhs, double limit = 0.0)
    {
        std::vector<int> columns{0};
        std::vector<double> values{0.0};
        for (std::size_t k = 0; k < form.size(); ++k) {
            if (std::abs(form[k]) > 1e-13) {
                columns.push_back(static_cast<int>(k) + 1);
                values.push_back(form[k]);
            }
        }
        if (limit != 0.0) {
            columns.push_back(static_cast<int>(size_) + 1);
            values.push_back(limit);
        }
        const int row = glp_add_rows(program_, 1);
        glp_set_mat_row(program_, row, static_cast<int>(columns.size()) - 1, columns.data(),
                        values.data());
        glp_set_row_bnds(program_, row, kind, rhs, rhs);
    }

    std::size_t size_;
    double impedance_;
    double gap_;
    std::vector<double> speeds_;
    std::vector<std::pair<std::deque<Form>, std::deque<Form>>> bars_;
    glp_prob* program_ = nullptr;
};

/// Two bars between clamps, drawn at random.
struct DrawnBars {
    std::int64_t left;
    std::int64_t right;
    double impedance;
    double speed;

    DrawnBars(std::mt19937_64& generator, bool hasSpeeds)
        : left(drawn(generator, 1, 5)),
          right(drawn(generator, 1, 5)),
          impedance(std::array{0.5, 1.0, 2.0}[static_cast<std::size_t>(drawn(generator, 0, 2))]),
          speed(hasSpeeds
                    ? std::array{0.5, 1.0, 1.5}[static_cast<std::size_t>(drawn(generator, 0, 2))]
                    : 1.0)
    {
    }

    static std::int64_t drawn(std::mt19937_64& generator, std::int64_t low, std::int64_t high)
    {
        return std::uniform_int_distribution<std::int64_t>(low, high)(generator);
    }
    [[nodiscard]] std::string words() const
    {
        return "clamp " + std::to_string(left) + " gap=1e-3 " + std::to_string(right) + ":" +
               std::to_string(impedance) + ":" + std::to_string(speed) + " clamp";
    }
    /// By the program written here.
    [[nodiscard]] std::optional<double> leastLimit(std::int64_t contact, std::int64_t free) const
    {
        const double gap = sceneOf(words()).contacts.front().gap;
        return TwoBars(static_cast<std::size_t>(left), static_cast<std::size_t>(right), impedance,
                       speed, gap)
            .leastLimit(contact, free);
    }
};

LeastMotion within(Network network, double limit, std::int64_t contact, std::int64_t free)
{
    network.strainLimit = limit;
    return leastMotion(network, {{1, contact}, {0, free}},
                       1e9 * static_cast<double>(network.cells()));
}

}  // namespace

TEST_CASE("network strain: two bars keep the limits that a program written here says they can keep")
{
    std::mt19937_64 generator(20261126);
    int limited = 0;
    for (int k = 0; k < 1500; ++k) {
        const DrawnBars bars(generator, true);
        const std::int64_t cells = bars.left + bars.right;
        const std::int64_t contact = DrawnBars::drawn(generator, 1, 2 * cells);
        const std::int64_t free = DrawnBars::drawn(generator, 1, 3 * cells);
        const Network network = sceneOf(bars.words());
        const LeastMotion free0 = within(network, infinity, contact, free);
        const auto least = bars.leastLimit(contact, free);
        INFO(bars.words() << ", " << contact << " " << free << ": " << least.value_or(-1.0));
        REQUIRE(least.has_value() == (free0.status == Status::found));
        if (!least) {
            continue;
        }
        const double seen = -free0.residuals.extremes.leastStrain;
        CHECK(seen >= *least * (1.0 - 1e-6));
        for (const double factor : {0.999, 0.5, 1.001, 1.2}) {
            const LeastMotion answer = within(network, factor * *least, contact, free);
            INFO("limit times " << factor << ": " << answer.detail);
            REQUIRE(answer.status == (factor > 1.0 ? Status::found : Status::none));
            if (factor > 1.0) {
                CHECK(-answer.residuals.extremes.leastStrain <= factor * *least * (1.0 + 1e-9));
                CHECK(answer.energy >= free0.energy * (1.0 - 1e-9));
                CHECK(answer.provedEnergy <= answer.energy * (1.0 + 1e-12));
                CHECK(answer.provedEnergy == Approx(answer.energy).epsilon(1e-6));
                limited += answer.energy > free0.energy * (1.0 + 1e-6) ? 1 : 0;
            } else {
                CHECK(answer.provedEnergy >= 1e9 * static_cast<double>(network.cells()));
            }
        }
    }
    INFO(limited << " least energies grew");
    CHECK(limited > 50);
}

TEST_CASE("network strain: the least compression of two bars is what a program written here says",
          "[glpk]")
{
    std::mt19937_64 generator(20261127);
    int less = 0;
    for (int k = 0; k < 600; ++k) {
        const DrawnBars bars(generator, false);
        const std::int64_t cells = bars.left + bars.right;
        const std::int64_t contact = DrawnBars::drawn(generator, 1, 2 * cells);
        const std::int64_t free = 2 * cells * DrawnBars::drawn(generator, 1, 3) - contact;
        const auto known = free < 1 ? std::nullopt : bars.leastLimit(contact, free);
        if (!known) {
            continue;
        }
        const Network network = sceneOf(bars.words());
        const std::vector<ContactSpan> schedule{{1, contact}, {0, free}};
        const double largest = 1e9 * static_cast<double>(network.cells());
        const LeastMotion answer =
            wishedMotion(network, schedule, largest, {.objective = Objective::minPeakStrain}, {});
        INFO(bars.words() << ", " << contact << " " << free << ": " << answer.detail);
        REQUIRE(answer.status == Status::found);
        const double seen = -answer.residuals.extremes.leastStrain;
        CHECK(seen == Approx(*known).epsilon(1e-7));
        REQUIRE(answer.provedStrain.has_value());
        CHECK(*answer.provedStrain == Approx(*known).epsilon(2e-6));
        CHECK(*answer.provedStrain < *known);
        const LeastMotion whole = within(network, infinity, contact, free);
        less += seen < -whole.residuals.extremes.leastStrain * (1.0 - 1e-6) ? 1 : 0;
    }
    INFO(less << " motions of least energy are compressed by more");
    CHECK(less > 10);
}

TEST_CASE("network strain: bars under weight and forces, on springs and in flight are decided, too")
{
    struct Bars {
        const char* words;
        double gravity;
        std::int64_t contact;
        std::int64_t free;
    };
    for (const Bars& bars :
         {Bars{"4 stop=0", 10, 8, 24}, Bars{"clamp 6 stop=1e-3", 1e-3, 3, 17},
          Bars{"clamp 5 force=3e-3 stop=5e-3 2 clamp", 0, 1, 12},
          Bars{"spring=4 6 stop=1e-3", 0, 2, 18}, Bars{"stop=-1e-3 3:2 3 stop=1e-3", 0, 6, 9},
          Bars{"clamp 3 mass=2 3 gap=1e-3 4 clamp", 0, 2, 20}}) {
        Network network =
            networkOf(Assembly{.parts = partsOf(bars.words), .gravity = bars.gravity});
        const bool hasTwo = network.contacts.size() > 1;
        const std::vector<ContactSpan> schedule =
            hasTwo ? std::vector<ContactSpan>{{2, bars.contact},
                                              {0, bars.free},
                                              {1, bars.contact},
                                              {0, bars.free}}
                   : std::vector<ContactSpan>{{1, bars.contact}, {0, bars.free}};
        const auto least = [&](double limit) {
            network.strainLimit = limit;
            return leastMotion(network, schedule, 1e12);
        };
        const LeastMotion whole = least(infinity);
        INFO(bars.words << ": " << whole.detail);
        REQUIRE(whole.status != Status::undecided);
        if (whole.status == Status::none) {
            continue;
        }
        const double seen = -whole.residuals.extremes.leastStrain;
        bool wasNone = false;
        for (const double factor : {1.001, 0.999, 0.9, 0.7, 0.4, 0.1, 1e-3}) {
            const LeastMotion answer = least(factor * seen);
            INFO(factor << ": " << answer.detail);
            CHECK(answer.status != Status::undecided);
            if (factor > 1.0) {
                CHECK(answer.energy == Approx(whole.energy));
            }
            CHECK_FALSE(
                (wasNone && answer.status == Status::found));  // what excludes more excludes less
            wasNone = answer.status == Status::none;
            // Proofs are about the limit: they prove nothing about more.
            Network other = network;
            other.strainLimit = 1.01 * seen;
            if (wasNone) {
                CHECK(provedEnergy(answer.multipliers, network, schedule) >= 1e12);
                CHECK(provedEnergy(answer.multipliers, other, schedule) <=
                      whole.energy * (1.0 + 1e-9));
            }
        }
        CHECK(wasNone);
    }
}
