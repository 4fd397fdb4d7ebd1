#include "schemes.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "cvode_scheme.hpp"
#include "elements.hpp"
#include "solver.hpp"

namespace signorini::bench {

namespace {

/// Waves on cells, a step of time for each cell: wave finite elements. Exact where all that happens
/// is on the grid; contacts between its points are taken as means of a step.
class Characteristics final : public Scheme {
public:
    Characteristics(const MarchedBar& bar, int cells) : bar_(bar), right_(cells), left_(cells)
    {
        const double cell = 1.0 / cells;
        for (int i = 0; i < cells; ++i) {
            const double strain =
                (bar.displacement((i + 1) * cell) - bar.displacement(i * cell)) / cell;
            const double speed = bar.velocity((i + 0.5) * cell);
            right_[i] = 0.5 * (speed - strain);
            left_[i] = 0.5 * (speed + strain);
        }
        tip_ = bar.displacement(1.0);
    }

    void step(double time, double h) override
    {
        const Eigen::Index last = right_.size() - 1;
        const double pull = bar_.force(time + 0.5 * h);
        // Weight makes waves grow under way; what arrives in a step is its mean.
        const double arriving = right_[last] + 0.25 * bar_.weight * h;
        double speed = (2.0 * arriving + pull) / (1.0 + bar_.dashpot);
        const double left = bar_.wall - tip_;
        tip_ += h * speed;
        if (tip_ > bar_.wall - rounding) {
            // Nothing is divided where it comes to the wall just at the end of a step, or is there.
            if (left < rounding) {
                speed = 0.0;
            } else if (tip_ > bar_.wall + rounding) {
                speed = left / h;
            }
            tip_ = bar_.wall;
        }
        force_ = 2.0 * arriving + pull - (1.0 + bar_.dashpot) * speed;
        const double base = left_[0] + 0.25 * bar_.weight * h;
        std::rotate(right_.begin(), right_.end() - 1, right_.end());
        std::rotate(left_.begin(), left_.begin() + 1, left_.end());
        right_[0] = bar_.isClamped ? -base : base;
        left_[last] = speed - arriving;
        right_.array() += 0.5 * bar_.weight * h;
        left_.array() += 0.5 * bar_.weight * h;
        right_[0] -= 0.25 * bar_.weight * h;
        left_[last] -= 0.25 * bar_.weight * h;
    }

    [[nodiscard]] double tip() const override { return tip_; }
    [[nodiscard]] double force() const override { return force_; }
    [[nodiscard]] double energy() const override
    {
        const double cell = 1.0 / static_cast<double>(right_.size());
        double energy = cell * (right_.squaredNorm() + left_.squaredNorm());
        double u = tip_;
        for (Eigen::Index i = right_.size(); i-- > 0; u -= cell * (left_[i] - right_[i])) {
            energy -= bar_.weight * cell * (u - 0.5 * cell * (left_[i] - right_[i]));
        }
        return energy;
    }

private:
    static constexpr double rounding = 1e-12;
    MarchedBar bar_;
    Eigen::VectorXd right_;
    Eigen::VectorXd left_;
    double tip_;
    double force_ = 0.0;
};

/// Newmark with beta = (gamma + 1/2)^2/4: 1/2 is the trapezoidal rule, more of it damps. The wall
/// is a stiff spring.
class NewmarkPenalty final : public Scheme {
public:
    NewmarkPenalty(const MarchedBar& bar, int elements, double gamma)
        : model_(bar, elements, Mass::consistent),
          penalty_(penaltyOf(elements)),
          gamma_(gamma),
          beta_(0.25 * (gamma + 0.5) * (gamma + 0.5))
    {
    }

    void step(double time, double h) override
    {
        if (h != h_) {
            h_ = h;
            factor_ = Factor(
                model_.mass.plus(beta_ * h * h, model_.stiffness, gamma_ * h * model_.bar.dashpot));
            push_ = factor_.unit();
            acceleration_ =
                Factor(model_.mass)
                    .solve(model_.pull(model_.u, model_.v, time) - reaction() * model_.unit());
        }
        const double before = reaction();
        model_.u += h * model_.v + (0.5 - beta_) * h * h * acceleration_;
        model_.v += (1.0 - gamma_) * h * acceleration_;
        acceleration_ = factor_.solve(model_.pull(model_.u, model_.v, time + h));
        const double share = beta_ * h * h;
        const double tip = model_.tip() + share * acceleration_[model_.last()];
        if (const double depth = tip - model_.bar.wall; depth > 0.0) {
            acceleration_ -=
                penalty_ * depth / (1.0 + penalty_ * share * push_[model_.last()]) * push_;
        }
        model_.u += share * acceleration_;
        model_.v += gamma_ * h * acceleration_;
        force_ = 0.5 * (before + reaction());
    }

    [[nodiscard]] double tip() const override { return model_.tip(); }
    [[nodiscard]] double force() const override { return force_; }
    [[nodiscard]] double energy() const override
    {
        return model_.energy() + 0.5 * reaction() * reaction() / penalty_;
    }

private:
    [[nodiscard]] double reaction() const
    {
        return penalty_ * std::max(0.0, model_.tip() - model_.bar.wall);
    }

    ElementModel model_;
    double penalty_;
    double gamma_;
    double beta_;
    double h_ = 0.0;
    Factor factor_;
    Eigen::VectorXd push_;
    Eigen::VectorXd acceleration_;
    double force_ = 0.0;
};

/// The scheme of Moreau and Jean with theta = 1/2, an impact law with e = 0.
class MoreauJean final : public Scheme {
public:
    MoreauJean(const MarchedBar& bar, int elements) : model_(bar, elements, Mass::consistent) {}

    void step(double time, double h) override
    {
        if (h != h_) {
            h_ = h;
            factor_ = Factor(
                model_.mass.plus(0.25 * h * h, model_.stiffness, 0.5 * h * model_.bar.dashpot));
            push_ = factor_.unit();
        }
        Eigen::VectorXd change =
            factor_.solve(h * model_.pull(model_.u + 0.5 * h * model_.v, model_.v, time + 0.5 * h));
        const Eigen::Index tip = model_.last();
        force_ = 0.0;
        const bool isNear = model_.tip() + 0.5 * h * model_.v[tip] >= model_.bar.wall;
        if (const double speed = model_.v[tip] + change[tip]; isNear && speed > 0.0) {
            change -= speed / push_[tip] * push_;
            force_ = speed / push_[tip] / h;
        }
        model_.u += h * (model_.v + 0.5 * change);
        model_.v += change;
    }

    [[nodiscard]] double tip() const override { return model_.tip(); }
    [[nodiscard]] double force() const override { return force_; }
    [[nodiscard]] double energy() const override { return model_.energy(); }

private:
    ElementModel model_;
    double h_ = 0.0;
    Factor factor_;
    Eigen::VectorXd push_;
    double force_ = 0.0;
};

/// Central differences; the tip has no mass, its neighbour bears it, so the tip follows from
/// equilibrium (Khenous, Laborde and Renard 2008; Doyen, Ern and Piperno 2011).
class MassRedistribution final : public Scheme {
public:
    MassRedistribution(const MarchedBar& bar, int elements)
        : model_(bar, elements, Mass::redistributed)
    {
    }

    void step(double time, double h) override
    {
        const Eigen::Index tip = model_.last();
        kick(time, 0.5 * h);
        const double before = model_.tip();
        model_.u.head(tip) += h * model_.v.head(tip);
        const double stiffness = model_.stiffness.last;
        const double pull = stiffness * model_.u[tip - 1] + model_.bar.force(time + h);
        const double dashpot = model_.bar.dashpot / h;
        model_.u[tip] =
            std::min(model_.bar.wall, (pull + dashpot * before) / (stiffness + dashpot));
        model_.v[tip] = (model_.u[tip] - before) / h;
        const double reaction =
            pull - stiffness * model_.u[tip] - model_.bar.dashpot * model_.v[tip];
        force_ = 0.5 * (reaction_ + reaction);
        reaction_ = reaction;
        kick(time + h, 0.5 * h);
    }

    [[nodiscard]] double tip() const override { return model_.tip(); }
    [[nodiscard]] double force() const override { return force_; }
    [[nodiscard]] double energy() const override { return model_.energy(); }
    [[nodiscard]] double courant() const override { return 0.5; }

private:
    void kick(double time, double h)
    {
        const Eigen::Index tip = model_.last();
        const Eigen::VectorXd pull = model_.pull(model_.u, model_.v, time);
        model_.v.head(tip) +=
            h * (pull.head(tip).array() / model_.mass.diagonal.head(tip).array()).matrix();
    }

    ElementModel model_;
    double force_ = 0.0;
    double reaction_ = 0.0;
};

double cpuSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

const std::vector<std::string_view>& schemeNames()
{
    static const std::vector<std::string_view> names{"characteristics",         "Newmark, penalty",
                                                     "damped Newmark, penalty", "Moreau-Jean",
                                                     "mass redistribution",     "CVODE, penalty"};
    return names;
}

std::unique_ptr<Scheme> schemeOf(std::string_view name, const MarchedBar& bar, int elements)
{
    if (name == "characteristics") {
        return std::make_unique<Characteristics>(bar, elements);
    }
    if (name == "Newmark, penalty") {
        return std::make_unique<NewmarkPenalty>(bar, elements, 0.5);
    }
    if (name == "damped Newmark, penalty") {
        return std::make_unique<NewmarkPenalty>(bar, elements, 0.6);
    }
    if (name == "Moreau-Jean") {
        return std::make_unique<MoreauJean>(bar, elements);
    }
    if (name == "mass redistribution") {
        return std::make_unique<MassRedistribution>(bar, elements);
    }
    if (name == "CVODE, penalty") {
        return cvodeScheme(bar, elements);
    }
    throw std::logic_error("no such scheme: " + std::string(name));
}

TimeSteps march(std::string_view name, const MarchedBar& bar, int elements, double period,
                int periods, int kept)
{
    const double begin = cpuSeconds();
    const std::unique_ptr<Scheme> scheme = schemeOf(name, bar, elements);
    const auto steps = static_cast<int>(std::ceil(period * elements / scheme->courant() - 1e-9));
    const double h = period / steps;
    TimeSteps result;
    result.energyBefore = scheme->energy();
    result.samples.reserve(static_cast<std::size_t>(steps) * static_cast<std::size_t>(kept));
    for (int k = 0; k < steps * periods; ++k) {
        scheme->step(k * h, h);
        if (k < steps * kept) {
            result.samples.push_back({(k + 1) * h, scheme->tip(), scheme->force()});
        }
    }
    result.energyAfter = scheme->energy();
    result.seconds = cpuSeconds() - begin;
    return result;
}

}  // namespace signorini::bench
