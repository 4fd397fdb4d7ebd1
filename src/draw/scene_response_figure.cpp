#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <utility>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "scene_figures.hpp"
#include "two_panels.hpp"

namespace signorini {

namespace {

using namespace plot;
using answers::SceneFrequency;
using answers::SceneHarmonicMotion;

}  // namespace

FigureData sceneResponseFigure(const answers::SceneResponse& response)
{
    if (response.frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    const double low = response.frequencies.back().hertz;
    const double high = response.frequencies.front().hertz;
    constexpr double large = 0.8;
    constexpr double small = 0.25;  // of what repels
    std::vector<std::array<SeriesPair, 2>> contacts;
    for (std::size_t contact = 0; contact < response.bars.contacts.size(); ++contact) {
        contacts.push_back(
            {SeriesPair(contactDots(contact, large)), SeriesPair(contactDots(contact, small))});
    }
    const std::size_t two = contacts.size();  // where motions with two contacts are
    if (response.range.contacts > 1) {
        contacts.push_back({SeriesPair(dots(Role::strain, large, Marker::diamond)),
                            SeriesPair(dots(Role::strain, small, Marker::diamond))});
    }
    SeriesPair open(line(Role::faint, 2.4));
    SeriesPair unknown(dots(Role::ink, 0.8, Marker::cross));
    for (const SceneFrequency& at : response.frequencies) {
        at.touches() || at.reason ? open.breakOff() : open.add(at.hertz, 0.0, 0.0);
        if (at.motions.empty() && (at.touches() || at.reason)) {
            unknown.add(at.hertz, 0.0, 0.0);
        }
        for (const SceneHarmonicMotion& motion : at.motions) {
            const std::size_t which = motion.hasTwoContacts() ? two : motion.value.first().contact;
            const double force = motion.scales.force();
            contacts[which][motion.attracts() == false ? 1 : 0].add(
                at.hertz, motion.value.peakForce * force,
                motion.value.impulse * force * motion.scales.time);
        }
    }
    TwoPanels panels{.upper = {.name = "force", .place = {0.12, 0.95, 0.56, 0.85}},
                     .lower = {.name = "impulse",
                               .place = {0.12, 0.95, 0.25, 0.52},
                               .legend = Legend::below,
                               .legendRows = 2 + static_cast<int>(contacts.size())},
                     .above = {.words = "largest force", .base = "N"},
                     .below = {.words = "impulse per period", .base = "N s"}};
    panels.add(std::move(open), "bars that do not meet");
    for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
        auto& [usual, repelling] = contacts[contact];
        const std::string name =
            contact == two ? "two contacts" : fmt::format("contact {}", contact + 1);
        panels.lower.legendRows += repelling.above.x.empty() ? 0 : 1;
        panels.add(std::move(usual), name);
        panels.add(std::move(repelling), name + ", repels");
    }
    panels.add(std::move(unknown),
               fmt::format("they would, and no motion with {} is known",
                           response.range.contacts > 1 ? "one contact or two" : "one contact"));
    const double margin = high > low ? 0.02 * (high - low) : 0.02 * high;
    FigureData figure = std::move(panels).figure(
        fmt::format("{} of amplitude {},  {}",
                    response.range.place == Excited::tip ? "force" : "moving base",
                    withUnit(response.range.amplitude,
                             amplitudeUnitName(response.range.place, response.range.derivative)),
                    response.range.isExact ? "exact harmonic" : "harmonic in steps"),
        hertzAxis(low - margin, high + margin, answers::firstHertz(response.bars.reference)));
    figure.height = 14.0;
    return figure;
}

}  // namespace signorini
