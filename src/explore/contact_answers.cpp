#include "contact_answers.hpp"

#include <algorithm>
#include <numeric>

#include "harmonic_motion.hpp"
#include "infinity.hpp"

namespace signorini {

namespace {

using Eigen::Index;

/// G.
std::int64_t residuesOf(const Network& network, std::int64_t steps)
{
    std::int64_t common = network.stubs.empty() ? steps : 1;
    for (const CellRow& row : network.rows) {
        common = std::gcd(common, 2 * row.cells);
    }
    return common;
}

/// Forces are those at the middle of a step, a base goes straight from step to step.
std::complex<double> staircaseOf(const HarmonicNetwork& given)
{
    const double omega = given.omega();
    return given.place == Excited::tip ? turned(0.5 * omega)
                                       : (turned(omega) - 1.0) / std::complex<double>(0.0, omega);
}

/// Cells of the row from a node to the next one; 0 across a gap.
std::int64_t cellsAfter(const Network& network, std::size_t node)
{
    const auto row = std::find_if(network.rows.begin(), network.rows.end(),
                                  [node](const CellRow& one) { return one.left == node; });
    return row == network.rows.end() ? 0 : row->cells;
}

}  // namespace

ContactAnswers::ContactAnswers(const HarmonicNetwork& given, const OpenNetwork& open,
                               std::size_t contact, Drive drive)
    : given_(given),
      open_(open),
      contact_(contact),
      inSteps_(drive == Drive::inSteps ? staircaseOf(given) : 1.0),
      driven_(inSteps_ * open.arriving(given.cycles, open.sentByDrive()))
{
    period_.steps = given.steps;
    period_.cycles = given.cycles;
    period_.residues = residuesOf(given.network, given.steps);
    const Index harmonics = given.steps / period_.residues / 2 + 1;
    const OpenNetwork::Vector sent = open.sentBy(contact);
    const auto undamped =
        drive == Drive::inSteps ? OpenNetwork::Undamped::refused : OpenNetwork::Undamped::leftOut;
    answers_.resize(open.channels(), harmonics);
    answers_.col(0) = open.arrivingStill(contact);
    for (Index k = 1; k < harmonics; ++k) {
        answers_.col(k) = open.arriving(k, sent, undamped);
    }
    if (period_.residues > 1) {  // waves that k = 0 takes for a static shape
        (void)open.arriving(given.steps / period_.residues, sent, undamped);
    }
    offsets_ = offsets();
    const OpenNetwork::Vector nothing = OpenNetwork::Vector::Zero(open.channels());
    period_.alone = lengthOf(open.rateByPush(contact, nothing, contact));
    period_.usual = (inSteps_ * open.sentByDrive()).cwiseAbs().maxCoeff();
    const std::vector<Complex> own = rates(contact);
    if (drive == Drive::inSteps) {
        requireWork(own);
    }
    period_.contacts.push_back(askOf(contact, own));
    // Under the harmonic itself others are looked at where motions are measured.
    for (std::size_t other = 0; drive == Drive::inSteps && other < given.network.contacts.size();
         ++other) {
        if (other != contact) {
            period_.contacts.push_back(askOf(other, rates(other)));
        }
    }
}

std::vector<ContactAnswers::Complex> ContactAnswers::rates(std::size_t contact) const
{
    std::vector<Complex> spectrum{open_.driftRate(contact_)};
    for (Index k = 1; k < answers_.cols(); ++k) {
        spectrum.push_back(open_.rateByPush(contact, answers_.col(k), contact_));
    }
    return spectrum;
}

/// A harmonic push that moves the contact works on dashpots, Re g > 0: what moves nothing for some
/// pushes then moves nothing at all. \throws Resonance.
void ContactAnswers::requireWork(std::span<const Complex> rates) const
{
    constexpr double moving = 1e-6;   // of a push before waves return
    constexpr double working = 1e-9;  // |g|^2 of a dashpot at the contact is its work
    for (const Complex each : rates) {
        const Complex rate = each / period_.alone;
        if (lengthOf(rate) > moving && !(rate.real() >= working * std::norm(rate))) {
            throw Resonance("nothing damps what a push moves");
        }
    }
}

std::vector<std::int64_t> ContactAnswers::offsets() const
{
    const Network& network = given_.network;
    std::vector<std::int64_t> after(network.nodes.size(), 0);
    const NetworkContact& at = network.contacts[contact_];
    for (std::size_t node = at.node; node > 0; --node) {
        after[node - 1] = (after[node] + cellsAfter(network, node - 1)) % period_.residues;
    }
    const std::size_t last = at.node + (at.kind == ContactKind::gap ? 1 : 0);
    for (std::size_t node = last; node + 1 < network.nodes.size(); ++node) {
        after[node + 1] = (after[node] + cellsAfter(network, node)) % period_.residues;
    }
    return after;
}

/// Values at offset + i G of what has this spectrum, k <= n/(2 G): harmonics k and k + n/G are the
/// same for the steps of one residue, k and n/G - k conjugate. O((n/G)^2).
std::vector<double> ContactAnswers::inTime(const std::vector<Complex>& spectrum,
                                           std::int64_t offset) const
{
    const std::int64_t n = given_.steps;
    const std::int64_t members = n / period_.residues;
    std::vector<double> values;
    for (std::int64_t i = 0; i < members; ++i) {
        const std::int64_t time = (offset + i * period_.residues) % n;
        double sum = 0.5 * spectrum.front().real();
        std::int64_t at = 0;
        for (std::int64_t k = 1; 2 * k <= members; ++k) {
            at += time;
            at -= at < n ? 0 : n;
            const Complex turn = open_.turn(at);
            const Complex part =
                (2 * k == members ? 0.5 : 1.0) * spectrum[static_cast<std::size_t>(k)];
            sum += part.real() * turn.real() - part.imag() * turn.imag();
        }
        values.push_back(2.0 * sum / static_cast<double>(members));
    }
    return values;
}

ContactAnswers::Complex ContactAnswers::driven(std::size_t contact) const
{
    return inSteps_ * open_.rateByDrive(contact, driven_ / inSteps_);
}

ClosingContact ContactAnswers::askOf(std::size_t contact,
                                     const std::vector<Complex>& spectrum) const
{
    const NetworkContact& at = given_.network.contacts[contact];
    // Of a gap the side that pushes reach has it.
    const bool isBefore = at.node < given_.network.contacts[contact_].node;
    const std::size_t node = at.node + (at.kind == ContactKind::gap && isBefore ? 1 : 0);
    ClosingContact asked;
    asked.gap = at.gap;
    asked.driven = -driven(contact);
    asked.offset = contact == contact_ ? 0 : offsets_[node];
    asked.byPush = inTime(spectrum, asked.offset);
    asked.compliance = open_.compliance(contact, contact_);
    return asked;
}

std::optional<ContactAnswers::Permanent> ContactAnswers::permanent() const
{
    constexpr double immobile = 1e-9;  // of a push before waves return
    const double gap = given_.network.contacts[contact_].gap;
    if (gap >= 0.0) {
        return std::nullopt;
    }
    const OpenNetwork::Vector answer = open_.arriving(given_.cycles, open_.sentBy(contact_));
    const Complex mobility = open_.rateByPush(contact_, answer, contact_);
    const Complex moved = driven(contact_);
    const bool isImmobile = lengthOf(mobility) <= immobile * period_.alone;
    if (isImmobile && lengthOf(moved) > immobile * period_.usual) {
        return std::nullopt;
    }
    Permanent pushes{-gap / open_.compliance(contact_, contact_),
                     isImmobile ? 0.0 : -moved / mobility, infinity};
    const auto reach = [&pushes](double still, double swing) {
        pushes.upTo = swing > 0.0 ? std::min(pushes.upTo, still / swing) : pushes.upTo;
    };
    reach(pushes.still, lengthOf(pushes.swing));
    for (std::size_t other = 0; other < given_.network.contacts.size(); ++other) {
        if (other == contact_) {
            continue;
        }
        const Complex rate =
            driven(other) + pushes.swing * open_.rateByPush(other, answer, contact_);
        const double still =
            given_.network.contacts[other].gap + pushes.still * open_.compliance(other, contact_);
        if (still < 0.0) {
            return std::nullopt;
        }
        reach(still, lengthOf(rate / (given_.turn(1) - 1.0)));
    }
    return pushes;
}

void ContactAnswers::forEachWave(auto visit) const
{
    const auto rows = static_cast<Index>(given_.network.rows.size());
    for (Index row = 0; row < rows; ++row) {
        const std::int64_t cells = given_.network.rows[static_cast<std::size_t>(row)].cells;
        for (std::int64_t cell = cells; cell-- > 0;) {
            visit(2 * row, cell);
        }
        for (std::int64_t cell = 0; cell < cells; ++cell) {
            visit(2 * row + 1, cell);
        }
    }
    for (Index channel = 2 * rows; channel < open_.channels(); ++channel) {
        visit(channel, std::int64_t{0});
    }
}

NetworkStart ContactAnswers::startOf(Plane place, const std::vector<double>& pushes) const
{
    std::vector<double> waves;
    forEachWave([&](Index channel, std::int64_t m) {
        const Complex harmonic = driven_[channel] * given_.turn(m);
        waves.push_back(place.dot({harmonic.real(), harmonic.imag()}) +
                        arriving(channel, m, pushes));
    });
    const Network& network = given_.network;
    std::vector<double> displacements = displacementsOf(network, waves, {});
    if (given_.place == Excited::base) {
        for (std::size_t node = 0; node < displacements.size(); ++node) {
            const auto clamp = displacementOf(network, node).clamp;
            displacements[node] += clamp && network.nodes[*clamp].isShaken ? place.c : 0.0;
        }
    }
    return {std::move(waves), std::move(displacements)};
}

std::vector<SteadyHarmonic> ContactAnswers::wavesOf(Complex excitation,
                                                    const std::vector<SteadyHarmonic>& pushes,
                                                    std::span<const SteadyHarmonic> even) const
{
    std::vector<SteadyHarmonic> waves;
    forEachWave([&](Index channel, std::int64_t m) {
        const Complex driven = excitation * driven_[channel] * given_.turn(m);
        waves.push_back(SteadyHarmonic(0.0, driven) + even[static_cast<std::size_t>(channel)] +
                        arriving(channel, m, pushes));
    });
    return waves;
}

/// In a step m by pushes. O(n_c/G).
template <typename Value>
Value ContactAnswers::arriving(Index channel, std::int64_t m,
                               const std::vector<Value>& pushes) const
{
    if (byPush_.empty()) {
        for (Index c = 0; c < open_.channels(); ++c) {
            std::vector<Complex> spectrum;
            for (Index k = 0; k < answers_.cols(); ++k) {
                spectrum.push_back(answers_(c, k));
            }
            byPush_.push_back(inTime(spectrum, offsetOf(c)));
        }
    }
    const std::vector<double>& kernel = byPush_[static_cast<std::size_t>(channel)];
    Value sum{};
    const std::int64_t after = m + given_.steps - offsetOf(channel);
    for (std::int64_t k = after % period_.residues; k < static_cast<std::int64_t>(pushes.size());
         k += period_.residues) {
        const std::int64_t later = (after + given_.steps - k) % given_.steps;
        sum = sum + kernel[static_cast<std::size_t>(later / period_.residues)] *
                        pushes[static_cast<std::size_t>(k)];
    }
    return sum;
}

}  // namespace signorini
