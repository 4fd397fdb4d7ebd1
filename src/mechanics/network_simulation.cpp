#include "network_simulation.hpp"

#include <algorithm>

#include "infinity.hpp"

namespace signorini {

const NetworkSimulation::Law& NetworkSimulation::lawOf(ContactSet closed)
{
    for (const std::unique_ptr<Law>& law : laws_) {
        if (law->closed() == closed) {
            return *law;
        }
    }
    laws_.push_back(std::make_unique<Law>(network_, closed));
    return *laws_.back();
}

double NetworkSimulation::impulse() const
{
    CompensatedSum sum = impulse_;
    for (const Touch& touch : touches_) {
        sum.add(touch.push * (now_ - touch.since));
    }
    return sum.value();
}

double NetworkSimulation::distance(std::size_t contact) const
{
    const NetworkContact& place = network_.contacts[contact];
    const double here = displacement(place.node);
    if (place.kind == ContactKind::gap) {
        return place.gap - here + displacement(place.node + 1);
    }
    return place.kind == ContactKind::stopRight ? place.gap - here : place.gap + here;
}

/// v as the law and what arrives now make it; not yet committed.
double NetworkSimulation::freshVelocity(std::size_t node) const
{
    return law_->velocity(node).at(arriving_, force_, baseVelocity_);
}

double NetworkSimulation::closingSpeed(std::size_t contact) const
{
    return -openingOf(network_.contacts[contact],
                      [this](std::size_t node) { return freshVelocity(node); });
}

/// What has happened at a node until now is added up, and what arrives now is taken in.
void NetworkSimulation::touchNode(std::size_t number)
{
    Node& node = nodes_[number];
    const double lasted = now_ - node.since;
    if (lasted > 0.0) {
        node.displacement += node.velocity * lasted;
        if (node.isActed) {
            work_.add(node.power * lasted);
            dissipated_.add(node.loss * lasted);
            given_.add(node.external * lasted);
        }
    }
    node.since = now_;
    for (const std::size_t k : node.channels) {
        while (due_[k] <= now_ + same_) {
            channels_[k].pop();
            arriving_[k] = channels_[k].now;
            due_[k] = channels_[k].due();
        }
    }
}

/// Are its contacts open, and with distance? Then it is alone.
bool NetworkSimulation::isUntouched(std::size_t number) const
{
    const Node& node = nodes_[number];
    return (closed_ & node.touching) == 0 &&
           std::none_of(node.contacts.begin(), node.contacts.end(), [this](std::size_t j) {
               return touches_[j].isNear || due_[channels_.size() + j] <= now_ + same_;
           });
}

void NetworkSimulation::send(std::size_t number, double value)
{
    Channel& channel = channels_[number];
    if (value == channel.value()) {
        return;
    }
    const Front next{now_ + channel.delay, value};
    const std::size_t count = channel.count();
    if (count == 0 || next.time - channel.last(1).time > together_ || !joins(channel, next)) {
        if (count >= 2) {
            const Front last = channel.last(1);
            Front& before = channel.last(2);
            const double jump = std::abs(last.value - before.value);
            if (jump <= options_.mergeBelow) {
                const double duration = next.time - last.time;
                const double earlier = last.time - before.time;
                before.value =
                    (before.value * earlier + last.value * duration) / (earlier + duration);
                merged_ += jump * duration;
                --channel.end;
            }
        }
        channel.push(next);
    }
    due_[number] = channel.due();
}

/// What acts on a node from outside: forces, dashpot, springs, the clamp.
void NetworkSimulation::setPowers(std::size_t number)
{
    Node& node = nodes_[number];
    const NetworkNode& given = network_.nodes[number];
    const double v = node.velocity;
    const double force = given.force + (given.isDriven ? force_ : 0.0);
    node.power = force * v;
    node.loss = given.dashpot * v * v;
    node.external = force - given.dashpot * v;
    for (const std::size_t k : node.channels) {
        // A branch pulls with Z (w - leaving) = Z (2 w - v).
        const double pull = channels_[k].impedance * (2.0 * arriving_[k] - v);
        if (given.isClamped) {
            node.external -= pull;
            node.power -= pull * v;
        } else if (channels_[k].sign < 0.0) {
            node.external += pull;
        }
    }
}

/// (N): what enters the branches of a cluster, and what its nodes do from now on.
void NetworkSimulation::sendFrom(const Law::Scatterer& cluster)
{
    const LinearForm<double>& form = cluster.velocity;
    const double pulled = form.constant + form.perForce * force_ + form.perBase * baseVelocity_;
    double v = pulled;
    for (const auto& term : form.terms) {
        v += term.coefficient * arriving_[term.channel];
    }
    const auto& branches = cluster.branches;
    for (std::size_t k = 0; k < branches.size(); ++k) {
        const auto& branch = branches[k];
        const double wave = arriving_[branch.channel];
        double leaving = v - wave;
        if (branches.size() <= 2) {  // nothing is rounded where a wave only passes through
            leaving = branch.own * wave + pulled;
            if (branches.size() == 2) {
                const auto& other = branches[1 - k];
                leaving += other.weight * arriving_[other.channel];
            }
        }
        send(branch.entered, branch.sign * leaving);
    }
    for (std::size_t number = cluster.nodes.firstNode; number <= cluster.nodes.lastNode; ++number) {
        nodes_[number].velocity = v;
        if (nodes_[number].isActed) {
            setPowers(number);
        }
    }
}

void NetworkSimulation::predict(std::size_t contact)
{
    double due = infinity;
    if (!contains(closed_, contact)) {
        Touch& touch = touches_[contact];
        const double speed = -openingOf(network_.contacts[contact],
                                        [this](std::size_t node) { return velocity(node); });
        const double left = distance(contact);
        touch.isNear = left <= close_[contact];
        touch.nearest = std::min(touch.nearest, left);
        if (speed > slow_) {
            due = now_ + std::max(left, 0.0) / speed;
        }
    }
    due_[channels_.size() + contact] = due;
}

void NetworkSimulation::recordPath(std::size_t node)
{
    std::vector<NodePoint>& path = paths_[node];
    if (!path.empty() && path.back().time == time()) {
        path.pop_back();
    }
    path.push_back({time(), nodes_[node].displacement});
}

void NetworkSimulation::commit(const Range& range)
{
    std::size_t before = none;
    for (std::size_t node = range.first; node <= range.last; ++node) {
        if (const std::size_t cluster = law_->scattererOf(node); cluster != before) {
            sendFrom(law_->scatterers()[cluster]);
            before = cluster;
        }
    }
    for (std::size_t node = range.first; node <= range.last; ++node) {
        for (const std::size_t j : nodes_[node].contacts) {
            if (contains(closed_, j)) {
                setPush(j, law_->push(j).at(arriving_, force_, baseVelocity_));
            }
            predict(j);
        }
        if (nodes_[node].hasPath) {
            recordPath(node);
        }
    }
}

/// Finds which contacts are closed, and sends on what follows.
void NetworkSimulation::settle(Range range)
{
    for (std::size_t node = range.first; node <= range.last; ++node) {
        touchNode(node);
    }
    if (range.first != range.last || !isUntouched(range.first)) {
        include(range.first, range);
        include(range.last, range);
        // Each round closes or opens one; rounding cannot keep it going for ever.
        const std::size_t most = 4 * touches_.size() + 8;
        for (std::size_t round = 0; round < most && (opensOne(range) || closesOne(range));
             ++round) {
        }
    }
    commit(range);
}

void NetworkSimulation::takeClock()
{
    const auto valueOf = [this](const std::vector<double>& values) {
        return values.empty() ? 0.0 : values[static_cast<std::size_t>(driveStep_) % values.size()];
    };
    force_ = valueOf(drive_.forces);
    baseVelocity_ = valueOf(drive_.velocities);
    if (const auto steps = static_cast<std::int64_t>(drive_.velocities.size());
        driveStep_ < steps) {
        baseVelocity_ += drive_.lead / (static_cast<double>(steps) * drive_.step);
    }
    ++driveStep_;
    clock() = static_cast<double>(driveStep_) * drive_.step - drive_.past - base_;
}

void NetworkSimulation::takeEvent(std::size_t which)
{
    if (which < channels_.size()) {
        const std::size_t node = channels_[which].node;
        settle({node, node});
    } else if (which < channels_.size() + touches_.size()) {
        const std::size_t contact = which - channels_.size();
        const std::size_t node = network_.contacts[contact].node;
        meeting_ = contact;
        settle({node, node + (network_.contacts[contact].kind == ContactKind::gap ? 1 : 0)});
        meeting_ = none;
    } else {
        takeClock();
        for (std::size_t node = 0; node < nodes_.size(); ++node) {
            if (network_.nodes[node].isDriven || network_.nodes[node].isShaken) {
                settle({node, node});
            }
        }
    }
}

void NetworkSimulation::advance(double duration)
{
    const double longest = longestBase * static_cast<double>(network_.cells());
    for (; duration > longest; duration -= longest) {
        advanceTo(now_ + longest);
    }
    advanceTo(now_ + duration);
}

/// The first of the least times, four at a time: comparing one after the other waits for each.
std::size_t NetworkSimulation::earliest() const
{
    const auto lesser = [](double x, double y) { return y < x ? y : x; };
    const double* const due = due_.data();
    double least0 = due[0];
    double least1 = due[1];
    double least2 = due[2];
    double least3 = due[3];
    for (std::size_t k = lanes; k < due_.size(); k += lanes) {
        least0 = lesser(least0, due[k]);
        least1 = lesser(least1, due[k + 1]);
        least2 = lesser(least2, due[k + 2]);
        least3 = lesser(least3, due[k + 3]);
    }
    const double least = lesser(lesser(least0, least1), lesser(least2, least3));
    std::size_t k = 0;
    while (due[k] != least && k + 1 < due_.size()) {
        ++k;
    }
    return k;
}

void NetworkSimulation::advanceTo(double end)
{
    while (true) {
        const std::size_t next = earliest();
        if (!(due_[next] < end)) {
            break;
        }
        now_ = std::max(now_, due_[next]);
        takeEvent(next);
        ++events_;
    }
    now_ = end;
    rebase();
}

/// Widens a range by the cluster of a node.
void NetworkSimulation::include(std::size_t node, Range& range)
{
    const Cluster& cluster = law_->scatterers()[law_->scattererOf(node)].nodes;
    while (range.first > cluster.firstNode) {
        touchNode(--range.first);
    }
    while (range.last < cluster.lastNode) {
        touchNode(++range.last);
    }
}

/// Of the closed contacts that pull the one that pulls most opens.
bool NetworkSimulation::opensOne(const Range& range)
{
    if (closed_ == 0) {
        return false;
    }
    double least = -small_;
    std::size_t which = touches_.size();
    for (std::size_t j = 0; j < touches_.size(); ++j) {
        const std::size_t node = network_.contacts[j].node;
        if (contains(closed_, j) && node >= range.first && node <= range.last) {
            const double push = law_->push(j).at(arriving_, force_, baseVelocity_);
            if (push < least) {
                least = push;
                which = j;
            }
        }
    }
    if (which == touches_.size()) {
        return false;
    }
    open(which);
    return true;
}

/// An open contact without distance that would overlap closes.
bool NetworkSimulation::closesOne(Range& range)
{
    for (std::size_t node = range.first; node <= range.last; ++node) {
        for (const std::size_t j : nodes_[node].contacts) {
            const NetworkContact& place = network_.contacts[j];
            const bool isNear =
                touches_[j].isNear || j == meeting_ || due_[channels_.size() + j] <= now_ + same_;
            if (!isNear || contains(closed_, j) || (j != meeting_ && distance(j) > close_[j])) {
                continue;
            }
            if (place.kind == ContactKind::gap) {
                include(place.node, range);
                include(place.node + 1, range);
            }
            if (const double setsOut = closingSpeed(j); setsOut > slow_) {
                // It is met with the speed before the waves that arrive at this instant.
                const double came =
                    -openingOf(place, [this](std::size_t at) { return velocity(at); });
                close(j, came > slow_ ? came : setsOut);
                include(place.node, range);
                return true;
            }
        }
    }
    return false;
}

void NetworkSimulation::open(std::size_t contact)
{
    setPush(contact, 0.0);
    closed_ &= ~(ContactSet{1} << contact);
    law_ = &lawOf(closed_);
    Touch& touch = touches_[contact];
    if (touch.lasts && touch.event.impulse > 0.0) {
        done_.push_back(touch.event);
    }
    touch.lasts = false;
}

void NetworkSimulation::close(std::size_t contact, double speed)
{
    closed_ |= ContactSet{1} << contact;
    law_ = &lawOf(closed_);
    Touch& touch = touches_[contact];
    touch.since = now_;
    touch.lasts = true;
    touch.event = {contact, time(), time(), 0.0, 0.0, speed};
}

/// Adds up what the contact pushed with until now.
void NetworkSimulation::setPush(std::size_t contact, double push)
{
    Touch& touch = touches_[contact];
    const double lasted = now_ - touch.since;
    if (lasted > 0.0 && touch.push > 0.0) {
        pressed_ += touch.event.impulse == 0.0 ? 1 : 0;
        impulse_.add(touch.push * lasted);
        touch.event.impulse += touch.push * lasted;
        touch.pushed += touch.push * lasted;
        touch.event.peakForce = std::max(touch.event.peakForce, touch.push);
        touch.event.end = time();
        const ContactKind kind = network_.contacts[contact].kind;
        if (kind != ContactKind::gap) {
            given_.add((kind == ContactKind::stopRight ? -touch.push : touch.push) * lasted);
        }
    }
    touch.since = now_;
    touch.push = push > small_ ? push : 0.0;
}

}  // namespace signorini
