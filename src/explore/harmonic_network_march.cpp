#include "harmonic_network_march.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact_spans.hpp"
#include "harmonic_motion.hpp"
#include "harmonic_network_walk.hpp"
#include "largest.hpp"
#include "portable.hpp"

namespace signorini {

namespace {

constexpr std::size_t mostLanes = 600;
constexpr std::int64_t mostLaneSteps = 20'000'000;
constexpr int mostEvents = 200;  // in a lane of a step
constexpr double sameDistance = 1e-14;
constexpr double sameEvent = 1e-7;  // steps

}  // namespace

HarmonicNetworkMarch::HarmonicNetworkMarch(const HarmonicNetwork& given, double phase,
                                           const std::vector<HarmonicLane>& lanes,
                                           std::vector<double> distances, ContactSet closed,
                                           double mergeBelow)
    : given_(given),
      phase_(phase),
      mergeBelow_(mergeBelow),
      drive_(given.amplitude * turned(-phase)),
      distances_(std::move(distances)),
      lasting_(given.network.contacts.size(), 0),
      closed_(closed),
      laws_(given.network)
{
    setLaw();
    for (const HarmonicLane& lane : lanes) {
        add(lane.from, lane.to, {given.network, lane.waves});
    }
    for (std::size_t j = 0; j < distances_.size(); ++j) {
        if (contains(closed, j)) {
            lasting_[j] = contacts_.size();
            contacts_.push_back({.contact = j, .begin = -1.0});
        }
    }
}

HarmonicNetworkMarch HarmonicNetworkMarch::atRest(const HarmonicNetwork& given, double mergeBelow)
{
    const Network& network = given.network;
    const NetworkStart rest = startAtRest(network);
    HarmonicLane lane;
    lane.waves.reserve(rest.waves.size());
    for (const double wave : rest.waves) {
        lane.waves.emplace_back(wave);
    }
    std::vector<double> distances;
    ContactSet closed = 0;
    for (std::size_t j = 0; j < network.contacts.size(); ++j) {
        const NetworkContact& contact = network.contacts[j];
        distances.push_back(contact.gap + openingOf(contact, [&](std::size_t node) {
                                return rest.displacements[node];
                            }));
        if (contact.gap <= 0.0) {
            distances.back() = 0.0;
            closed |= ContactSet{1} << j;
        }
    }
    return {given,     0.5 * std::numbers::pi, {std::move(lane)}, std::move(distances), closed,
            mergeBelow};
}

bool HarmonicNetworkMarch::advance(std::int64_t steps)
{
    for (const std::int64_t until = step_ + steps; step_ < until; ++step_) {
        const HarmonicNetwork::Drive drive = given_.drive(drive_ * given_.turn(step_));
        force_.swing = drive.force;
        base_.swing = drive.base;
        for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
            if (++laneSteps_ > mostLaneSteps || !stepLane(lane)) {
                return false;
            }
        }
        if (mergeBelow_ > 0.0 && (step_ + 1) % given_.steps == 0) {
            merge();
        }
    }
    return lanes_.size() <= mostLanes;
}

std::vector<HarmonicLane> HarmonicNetworkMarch::lanes() const
{
    std::vector<HarmonicLane> all;
    all.reserve(lanes_.size());
    for (const Lane& lane : lanes_) {
        all.push_back({lane.from, lane.to, lane.waves.waves()});
    }
    return all;
}

void HarmonicNetworkMarch::setLaw()
{
    law_ = &laws_.of(closed_);
}

void HarmonicNetworkMarch::add(double from, double to, NetworkWaves<SteadyHarmonic> waves)
{
    lanes_.push_back({from, to, given_.weight(from, to), std::move(waves)});
}

/// A lane of a step, cut at its first event; what is cut off is a lane of its own.
bool HarmonicNetworkMarch::stepLane(std::size_t k)
{
    for (int events = 0;; ++events) {
        const Event event = firstEvent(lanes_[k]);
        if (events == mostEvents || lanes_.size() > mostLanes) {
            return false;
        }
        if (!(event.at < lanes_[k].to)) {
            break;
        }
        if (event.at > lanes_[k].from) {
            Lane later = lanes_[k];
            later.from = event.at;
            later.weight = given_.weight(event.at, later.to);
            lanes_[k].to = event.at;
            lanes_[k].weight = given_.weight(lanes_[k].from, event.at);
            lanes_.insert(lanes_.begin() + static_cast<std::ptrdiff_t>(k) + 1, std::move(later));
            break;
        }
        change(event, lanes_[k]);
    }
    Lane& lane = lanes_[k];
    for (std::size_t j = 0; j < distances_.size(); ++j) {
        if (!contains(closed_, j)) {
            distances_[j] += lane.integral(rateOf(j, lane));
        }
    }
    lane.waves.step(*law_, force_, base_);
    return true;
}

SteadyHarmonic HarmonicNetworkMarch::rateOf(std::size_t contact, const Lane& lane) const
{
    return openingOf(given_.network.contacts[contact], [&](std::size_t node) {
        return law_->velocity(node).at(lane.waves.arriving(), force_, base_);
    });
}

HarmonicNetworkMarch::Event HarmonicNetworkMarch::firstEvent(const Lane& lane) const
{
    Event first{lane.to, 0};
    for (std::size_t j = 0; j < distances_.size(); ++j) {
        const double at =
            contains(closed_, j)
                ? release(law_->push(j).at(lane.waves.arriving(), force_, base_), lane)
                : closure(rateOf(j, lane), lane, distances_[j]);
        if (at < first.at) {
            first = {at, j};
        }
    }
    return first;
}

/// Where a contact would have to pull.
double HarmonicNetworkMarch::release(const SteadyHarmonic& push, const Lane& lane) const
{
    if (push.steady >= lengthOf(push.swing)) {
        return lane.to;
    }
    double from = lane.from;
    for (const double to : turns(push, lane)) {
        if (value(push, 0.5 * (from + to)) < 0.0) {
            return from;
        }
        from = to;
    }
    return lane.to;
}

/// Where the distance is 0, or at the start of the lane if it is there and grows less.
double HarmonicNetworkMarch::closure(const SteadyHarmonic& rate, const Lane& lane,
                                     double distance) const
{
    if (distance > rate.largest() * (lane.to - lane.from)) {
        return lane.to;
    }
    // As `Lane::integral` has it, so that a lane cut there ends at a distance that is not above 0.
    const auto distanceAt = [&](double s) {
        return distance +
               (rate.steady * (s - lane.from) + (rate.swing * given_.weight(lane.from, s)).real());
    };
    const auto isBeyond = [&](double s) { return distanceAt(s) <= 0.0; };
    double from = lane.from;
    for (const double to : turns(rate, lane)) {
        if (value(rate, 0.5 * (from + to)) < 0.0 && isBeyond(to)) {
            double low = from;
            double high = to;
            if (isBeyond(low)) {
                if (distanceAt(to) >= -sameDistance * rate.largest()) {
                    from = to;
                    continue;
                }
                return low;
            }
            while (low < 0.5 * (low + high) && 0.5 * (low + high) < high) {
                const double middle = 0.5 * (low + high);
                (isBeyond(middle) ? high : low) = middle;
            }
            return high;
        }
        from = to;
    }
    return lane.to;
}

/// Where z changes its sign within the lane, ascending, and the end of the lane.
std::vector<double> HarmonicNetworkMarch::turns(const SteadyHarmonic& z, const Lane& lane) const
{
    std::vector<double> all;
    const double size = lengthOf(z.swing);
    if (std::abs(z.steady) < size) {
        const double apart = portable::acos(-z.steady / size);
        const double omega = given_.omega();
        for (const double side : {apart, -apart}) {
            const double angle = side - angleOf(z.swing) - omega * lane.from;
            const double turn = 2.0 * std::numbers::pi;
            const double s = lane.from + (angle - turn * std::floor(angle / turn)) / omega;
            if (s > lane.from && s < lane.to) {
                all.push_back(s);
            }
        }
        std::sort(all.begin(), all.end());
    }
    all.push_back(lane.to);
    return all;
}

double HarmonicNetworkMarch::value(const SteadyHarmonic& z, double s) const
{
    return z.at(turned(given_.omega() * s));
}

/// A contact opens or closes as a lane begins.
void HarmonicNetworkMarch::change(const Event& event, const Lane& lane)
{
    const std::size_t j = event.contact;
    const double time = static_cast<double>(step_) + event.at;
    if (contains(closed_, j)) {
        // A push that fades is 0 here; what a front has left of it is not.
        const SteadyHarmonic push = law_->push(j).at(lane.waves.arriving(), force_, base_);
        contacts_[lasting_[j]].end = time;
        contacts_[lasting_[j]].isPinned = value(push, lane.from) < -1e-9 * push.largest();
    } else {
        lasting_[j] = contacts_.size();
        contacts_.push_back(
            {.contact = j, .begin = time, .speed = -value(rateOf(j, lane), lane.from)});
    }
    distances_[j] = 0.0;
    closed_ ^= ContactSet{1} << j;
    setLaw();
}

/// Lanes that are too short, or too much alike, to tell.
void HarmonicNetworkMarch::merge()
{
    std::vector<HarmonicLane> all = lanes();
    const double least = mergeBelow_ * largestOf(all, [](const auto& one) {
                             return largestOf(one.waves, &SteadyHarmonic::largest);
                         });
    std::vector<HarmonicLane> kept;
    kept.reserve(all.size());
    for (HarmonicLane& next : all) {
        if (!kept.empty()) {
            HarmonicLane& last = kept.back();
            double apart = 0.0;
            for (std::size_t i = 0; i < next.waves.size(); ++i) {
                apart = std::max(apart, (next.waves[i] - last.waves[i]).largest());
            }
            const double length = std::min(last.to - last.from, next.to - next.from);
            if (apart * length <= least) {
                if (next.to - next.from > last.to - last.from) {
                    last.waves = std::move(next.waves);
                }
                last.to = next.to;
                continue;
            }
        }
        kept.push_back(std::move(next));
    }
    if (kept.size() == lanes_.size()) {
        return;
    }
    lanes_.clear();
    for (const HarmonicLane& lane : kept) {
        add(lane.from, lane.to, {given_.network, lane.waves});
    }
}

std::vector<NetworkHarmonicContact> contactsAfter(const HarmonicNetwork& given,
                                                  const NetworkHarmonicMotion& motion)
{
    const auto period = static_cast<double>(given.steps);
    ContactSet closed = 0;
    for (const NetworkHarmonicContact& one : motion.contacts) {
        closed |= one.end > period + sameEvent ? ContactSet{1} << one.contact : 0;
    }
    std::vector<double> distances = startDistances(given, motion);
    distances[motion.first().contact] = 0.0;
    HarmonicNetworkMarch march(given, motion.phase, motion.lanes, std::move(distances), closed,
                               0.0);
    if (!march.advance(given.steps)) {
        return {};
    }
    std::vector<NetworkHarmonicContact> found;
    for (const NetworkHarmonicContact& one : march.contacts()) {
        if (one.begin >= 0.0 && one.begin < period - sameEvent) {
            found.push_back(one);
        }
    }
    for (NetworkHarmonicContact& one : found) {
        if (one.end == 0.0) {  // it lasts into the next period
            const auto& all = march.contacts();
            const auto rest = std::find_if(all.begin(), all.end(), [&](const auto& other) {
                return other.contact == one.contact && other.begin < 0.0;
            });
            one.end = period + (rest == all.end() ? 0.0 : rest->end);
            one.isPinned = rest == all.end() || rest->isPinned;
        }
    }
    return found;
}

}  // namespace signorini
