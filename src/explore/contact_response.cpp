#include "contact_response.hpp"

#include <cmath>
#include <functional>

#include "contact_answers.hpp"
#include "forced_case.hpp"
#include "forced_polytope.hpp"
#include "forced_set.hpp"
#include "harmonic_motion.hpp"
#include "infinity.hpp"
#include "network_find.hpp"
#include "network_forced.hpp"
#include "network_simulation.hpp"
#include "two_contacts.hpp"

namespace signorini {

namespace {

/// What begins a motion: a contact that is closed in so many steps from the start.
struct ContactStart {
    std::size_t contact = 0;
    std::int64_t closed = 0;
    Plane place;         ///< (C, S)
    NetworkStart start;  ///< waves and displacements, by the harmonic and the pushes
};
/// The motion of it, verified.
using MotionFrom = std::function<ForcedMotion(const ContactStart&)>;

/// One schedule by programs of its own.
void addAlone(FrequencyResponse& response, const HarmonicNetwork& given, std::size_t contact,
              std::int64_t closed, const MotionFrom& motionFrom)
{
    const std::vector<ContactSpan> spans = spansOf(contact, closed, given.steps);
    const ForcedSet set = forcedScene(given.network, spans, {given.place, given.cycles, {}},
                                      usualEnergy(given.network, spans));
    if (set.status == Status::undecided) {
        addUndecided(response, set.detail);
    }
    if (set.status != Status::found) {
        return;
    }
    response.branches.push_back({closed, set.leastAmplitude, set.mostAmplitude});
    std::vector<ForcedMotion> motions;
    for (const ForcedMotion& motion : motionsOfAmplitude(set, given.amplitude)) {
        const Plane place{motion.amplitude * std::cos(motion.phase),
                          motion.amplitude * std::sin(motion.phase)};
        motions.push_back(motionFrom({contact,
                                      closed,
                                      place,
                                      {{motion.state.a.begin(), motion.state.a.end()},
                                       {motion.state.b.begin(), motion.state.b.end()}}}));
    }
    addBelievable(response, std::move(motions));
}

/// One contact of a network, all lengths of it.
class ContactSearch {
public:
    ContactSearch(const HarmonicNetwork& given, const OpenNetwork& open, std::size_t contact,
                  const MotionFrom& motionFrom)
        : given_(given),
          contact_(contact),
          motionFrom_(motionFrom),
          answers_(given, open, contact, Drive::inSteps),
          waves_(answers_.period())
    {
        response_.found.steps = given.steps;
        response_.found.linearPeak = given.amplitude * waves_.linearPeak();
        response_.found.touches = response_.found.linearPeak >= gap();
        response_.found.openUpTo = gap() < 0.0                 ? 0.0
                                   : waves_.linearPeak() > 0.0 ? gap() / waves_.linearPeak()
                                                               : infinity;
        response_.distance = gap() - response_.found.linearPeak;
    }

    std::optional<ContactResponse> run(const Cancel& cancel)
    {
        while (waves_.contact() + 1 < given_.steps) {
            if (waves_.contact() % 16 == 0 && isRequested(cancel)) {
                return std::nullopt;
            }
            waves_.grow();
            addMotions();
        }
        addPermanent();
        return std::move(response_);
    }

private:
    [[nodiscard]] double gap() const { return given_.network.contacts[contact_].gap; }

    void addMotions()
    {
        FrequencyResponse& found = response_.found;
        if (!waves_.isClear()) {
            addUndecided(found, "rounding spoils the pushes of so long a contact");
            return;
        }
        if (!waves_.opens()) {
            return;  // permanent contact, with waves of its own or without
        }
        const bool hasFree = waves_.freePushes() > 0;
        const ForcedLine line = waves_.lineBounds() ? waves_.line() : ForcedLine{};
        if (line.isEmpty()) {
            return;
        }
        if (hasFree) {
            addPolytope();
            return;
        }
        addBranches(found, waves_.contact(), line);
        addBelievable(found, motionsOnLine(line, given_.amplitude,
                                           [&](double t) { return motionAt(line.at(t), {}); }));
    }

    void addPolytope()
    {
        FrequencyResponse& found = response_.found;
        const ForcedPolytope set = forcedPolytope(waves_.rows(), {true, waves_.freePushes()});
        if (set.corners.empty()) {
            if (!set.conflict) {
                addUndecided(found, set.detail);
            }
            return;
        }
        const auto [least, most] = amplitudesOf(set);
        if (gap() == 0.0 && most <= leastOfCone) {
            return;  // the network at rest
        }
        found.branches.push_back({waves_.contact(), least, most});
        if (least <= given_.amplitude && given_.amplitude <= most) {
            const ForcedCorner corner =
                meanAt(set.corners, placeOfAmplitude(set.corners, given_.amplitude));
            addBelievable(found, {motionAt({corner.place[0], corner.place[1]}, corner.free)});
        }
    }

    [[nodiscard]] ForcedMotion motionAt(Plane place, std::span<const double> free)
    {
        std::vector<double> pushes;
        for (std::int64_t m = 0; m < waves_.contact(); ++m) {
            pushes.push_back(waves_.push(m).dot(place) + waves_.freePush(m, free));
        }
        return motionFrom_({contact_, waves_.contact(), place, answers_.startOf(place, pushes)});
    }

    /// Pushes in all steps: a static one and a harmonic, which keeps the contact closed.
    void addPermanent()
    {
        const auto found = answers_.permanent();
        response_.leastPush =
            found ? found->still - given_.amplitude * lengthOf(found->swing) : -1.0;
        if (found) {
            response_.found.permanentUpTo = found->upTo;
        }
        if (!found || response_.leastPush < 0.0 || given_.amplitude > found->upTo) {
            return;
        }
        std::vector<double> pushes;
        for (std::int64_t m = 0; m < given_.steps; ++m) {
            pushes.push_back(found->still +
                             given_.amplitude * (found->swing * given_.turn(m)).real());
        }
        const Plane place{given_.amplitude, 0.0};
        response_.permanent =
            motionFrom_({contact_, given_.steps, place, answers_.startOf(place, pushes)});
    }

    const HarmonicNetwork& given_;
    std::size_t contact_;
    const MotionFrom& motionFrom_;
    ContactAnswers answers_;
    GrowingContact waves_;
    ContactResponse response_;
};

/// Where nothing damps some waves, or bars drift.
std::optional<ContactResponse> scheduleByScheduleOf(const HarmonicNetwork& given,
                                                    std::size_t contact,
                                                    const MotionFrom& motionFrom,
                                                    const Cancel& cancel)
{
    ContactResponse response;
    response.found.steps = given.steps;
    response.found.touches = true;
    for (std::int64_t closed = 1; closed < given.steps; ++closed) {
        if (isRequested(cancel)) {
            return std::nullopt;
        }
        addAlone(response.found, given, contact, closed, motionFrom);
    }
    return response;
}

/// By contact, with motions as they are made of what begins them.
std::optional<std::vector<ContactResponse>> responsesWith(const HarmonicNetwork& given,
                                                          const MotionFrom& motionFrom,
                                                          const Cancel& cancel)
{
    requireAsked(given, maxStaircaseSteps);
    StillNetwork shape;
    std::optional<HarmonicNetwork> still;  // none: a bar drifts
    std::optional<OpenNetwork> open;
    MotionFrom moved;
    if (driftingBars(given.network).empty()) {
        shape = underConstantForces(given.network);
        still = given;
        still->network = shape.network;
        open.emplace(*still);
        moved = [&shape, &motionFrom](ContactStart from) {
            shape.addShape(from.start);
            return motionFrom(from);
        };
    }
    std::vector<ContactResponse> all;
    for (std::size_t contact = 0; contact < given.network.contacts.size(); ++contact) {
        std::optional<ContactResponse> response;
        try {
            response = open ? ContactSearch(*still, *open, contact, moved).run(cancel)
                            : scheduleByScheduleOf(given, contact, motionFrom, cancel);
        } catch (const Resonance&) {
            response = scheduleByScheduleOf(given, contact, motionFrom, cancel);
        }
        if (!response) {
            return std::nullopt;
        }
        all.push_back(std::move(*response));
    }
    return all;
}

}  // namespace

std::vector<ContactSpan> spansOf(std::size_t contact, std::int64_t closed, std::int64_t steps)
{
    std::vector<ContactSpan> spans{{ContactSet{1} << contact, closed}};
    if (closed < steps) {
        spans.push_back({0, steps - closed});
    }
    return spans;
}

std::optional<std::vector<ContactResponse>> contactResponses(const HarmonicNetwork& given,
                                                             const Cancel& cancel)
{
    const std::vector<Excitation> shapes =
        shapesOf({given.place, given.cycles, {}}, 1, given.steps);
    const MotionFrom walked = [&](const ContactStart& from) {
        const std::int64_t flight = given.steps - from.closed;
        ForcedMotion motion = drivenMotion({given.network.cells(), {{from.closed, flight}}, {}}, {},
                                           shapes, from.place);
        enterWalk(motion, given.network, spansOf(from.contact, from.closed, given.steps),
                  from.start);
        return motion;
    };
    return responsesWith(given, walked, cancel);
}

std::optional<FrequencyResponse> steppedResponseAt(const ResponseRange& range, std::int64_t steps,
                                                   const Cancel& cancel)
{
    const auto cells = static_cast<double>(range.cells);
    const double unit = range.place == Excited::tip ? 1.0 : cells;  // in those of the network
    const HarmonicNetwork given{networkOf(range.stops, range.segments, range.cells, range.damping),
                                range.place, unit * range.amplitude, steps, range.cycles};
    const std::vector<Excitation> shapes =
        shapesOf({range.place, range.cycles, {}}, range.cells, steps);
    const MotionFrom motionFrom = [&](const ContactStart& from) {
        const Schedule schedule{
            range.cells,
            {{from.closed, steps - from.closed, from.contact == 0 ? Stop::right : Stop::left}},
            range.stops};
        ForcedMotion motion =
            drivenMotion(schedule, range.damping, shapes, (1.0 / unit) * from.place);
        enterState(motion, range.segments, stateOf(given.network, from.start.waves));
        return motion;
    };
    const auto contacts = responsesWith(given, motionFrom, cancel);
    if (!contacts) {
        return std::nullopt;
    }
    FrequencyResponse all;
    all.steps = steps;
    all.frequencyRatio =
        4.0 * cells * static_cast<double>(range.cycles) / static_cast<double>(steps);
    all.linearPeak = contacts->front().found.linearPeak / cells;
    all.openUpTo = infinity;
    for (const auto& [found, permanent, leastPush, distance] : *contacts) {
        all.openUpTo = distance ? std::min(all.openUpTo, found.openUpTo / unit) : all.openUpTo;
        all.touches = all.touches || found.touches;
        all.detail = all.undecided == 0 ? found.detail : all.detail;
        all.undecided += found.undecided;
        all.motions.insert(all.motions.end(), found.motions.begin(), found.motions.end());
        for (const AmplitudeBranch& branch : found.branches) {
            all.branches.push_back({branch.contact, branch.least / unit, branch.most / unit});
        }
        all.permanentUpTo = std::max(all.permanentUpTo, found.permanentUpTo / unit);
        if (permanent) {
            all.permanent = {leastPush, permanent->extremes, permanent->residual};
        }
    }
    if (range.contacts > 1 && !addTwoContacts(all, given, pairsOf(range), cancel)) {
        return std::nullopt;
    }
    return all;
}

}  // namespace signorini
