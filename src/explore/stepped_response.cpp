#include "stepped_response.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "faults.hpp"
#include "forced_case.hpp"
#include "forced_polytope.hpp"
#include "growing_contact.hpp"

namespace signorini {

namespace {

/// What arrives at the right end of a segment, and what leaves it to the left, in each step of a
/// period.
struct RightEnd {
    std::vector<double> arriving;
    std::vector<double> leaving;

    [[nodiscard]] static double at(const std::vector<double>& wave, std::int64_t m)
    {
        const auto n = static_cast<std::int64_t>(wave.size());
        return wave[static_cast<std::size_t>((m % n + n) % n)];
    }

    /// Of the segment to the left, behind a joint, over which as much has passed.
    [[nodiscard]] RightEnd beyond(const Segment& left, const Segment& here) const
    {
        RightEnd end;
        for (std::size_t k = 0; k < arriving.size(); ++k) {
            const auto m = static_cast<std::int64_t>(k);
            const double back = at(leaving, m - here.cells);
            const double speed = at(arriving, m + here.cells) + back;
            const double pulled =
                (here.impedance + left.dashpot) * speed - 2.0 * here.impedance * back;
            end.arriving.push_back(0.5 * (speed + pulled / left.impedance));
            end.leaving.push_back(speed - end.arriving.back());
        }
        return end;
    }
};

/// All schedules of n steps, by ascending n_c.
class SteppedSearch {
public:
    SteppedSearch(const ResponseRange& range, std::int64_t steps)
        : range_(range),
          bar_(steppedBar(range.segments)),
          shapes_(shapesOf({range.place, range.cycles, {}}, range.cells, steps)),
          schedule_{range.cells, {{1, steps - 1}}, range.stops},
          waves_(bar_, range.damping.eta(), range.place, range.cycles, steps)
    {
        response_.steps = steps;
        response_.frequencyRatio = 4.0 * static_cast<double>(range.cells) *
                                   static_cast<double>(range.cycles) / static_cast<double>(steps);
        response_.linearPeak = range.amplitude * waves_.linearPeak();
        response_.touches = response_.linearPeak >= 1.0;
    }

    std::optional<FrequencyResponse> run(const Cancel& cancel)
    {
        while (waves_.contact() + 1 < response_.steps) {
            if (waves_.contact() % 16 == 0 && isRequested(cancel)) {
                return std::nullopt;
            }
            waves_.grow();
            schedule_.phases = {{waves_.contact(), response_.steps - waves_.contact()}};
            addMotions();
        }
        return std::move(response_);
    }

private:
    void addMotions()
    {
        const auto line = waves_.line();
        if (!line) {
            addUndecided(response_, "rounding spoils the pushes of so long a contact");
        } else if (!line->isEmpty() && waves_.freePushes() > 0) {
            addPolytope();
        } else if (!line->isEmpty()) {
            addBranches(response_, waves_.contact(), *line);
            addBelievable(response_, motionsOnLine(*line, range_.amplitude, [&](double t) {
                              return motionAt(line->at(t), {});
                          }));
        }
    }

    void addPolytope()
    {
        const ForcedPolytope found = forcedPolytope(waves_.rows(), {true, waves_.freePushes()});
        if (found.corners.empty()) {
            if (!found.conflict) {
                addUndecided(response_, found.detail);
            }
            return;
        }
        const auto [least, most] = amplitudesOf(found);
        response_.branches.push_back({waves_.contact(), least, most});
        if (least <= range_.amplitude && range_.amplitude <= most) {
            const ForcedCorner corner =
                meanAt(found.corners, placeOfAmplitude(found.corners, range_.amplitude));
            addBelievable(response_, {motionAt({corner.place[0], corner.place[1]}, corner.free)});
        }
    }

    [[nodiscard]] ForcedMotion motionAt(Plane place, std::span<const double> free) const
    {
        ForcedMotion motion = drivenMotion(schedule_, range_.damping, shapes_, place);
        enterState(motion, bar_.segments, stateAt(motion.excitation, place, free));
        return motion;
    }

    /// From what the tip does in a period inwards, joint by joint.
    [[nodiscard]] State stateAt(const Excitation& excitation, Plane place,
                                std::span<const double> free) const
    {
        const double z = bar_.segments.back().impedance;
        const double eta = range_.damping.eta();
        RightEnd end;
        for (std::int64_t m = 0; m < response_.steps; ++m) {
            const bool isHeld = m < waves_.contact();
            const double push = isHeld ? waves_.push(m).dot(place) + waves_.freePush(m, free) : 0.0;
            const double speed = isHeld ? 0.0 : waves_.speed(m).dot(place);
            end.arriving.push_back(0.5 * (push - excitation.force(m) + (z + eta) * speed) / z);
            end.leaving.push_back(speed - end.arriving.back());
        }
        State state{Eigen::VectorXd(bar_.cells), Eigen::VectorXd(bar_.cells)};
        Eigen::Index last = bar_.cells - 1;
        for (std::size_t i = bar_.segments.size(); i-- > 0;) {
            const Segment& segment = bar_.segments[i];
            for (std::int64_t k = 0; k < segment.cells; ++k, --last) {
                state.a[last] = RightEnd::at(end.arriving, k);
                state.b[last] = RightEnd::at(end.leaving, -1 - k);
            }
            end = i > 0 ? end.beyond(bar_.segments[i - 1], segment) : end;
        }
        return state;
    }

    const ResponseRange& range_;
    SteppedBar bar_;
    std::vector<Excitation> shapes_;
    Schedule schedule_;
    GrowingContact waves_;
    FrequencyResponse response_;
};

}  // namespace

void requireStepped(const ResponseRange& range)
{
    Faults faults;
    const char* where = " for a bar of several segments";
    if (range.stops != Stops{}) {
        faults.add("stops", range.stops.left ? "a second stop" : "gap <= 0",
                   std::string("a gap > 0 and one stop") + where);
    }
    if (range.contacts > 1) {
        faults.add("contacts", range.contacts, std::string("1") + where);
    }
    faults.throwIfAny();
}

std::optional<FrequencyResponse> steppedResponseAt(const ResponseRange& range, std::int64_t steps,
                                                   const Cancel& cancel)
{
    return SteppedSearch(range, steps).run(cancel);
}

}  // namespace signorini
