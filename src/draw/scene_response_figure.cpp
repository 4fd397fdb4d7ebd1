#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "axes.hpp"
#include "excited_amplitude.hpp"
#include "scene_figures.hpp"

namespace signorini {

namespace {

using namespace plot;
using answers::SceneFrequency;
using answers::SceneHarmonicMotion;

double forceOf(const SceneHarmonicMotion& motion)
{
    return motion.value.peakForce * motion.scales.force();
}

double impulseOf(const SceneHarmonicMotion& motion)
{
    return motion.value.impulse * motion.scales.force() * motion.scales.time;
}

/// A dot for each motion at a contact, in the panels of force and impulse.
struct ContactDots {
    Series force;
    Series impulse;

    ContactDots(std::size_t contact, double size)
        : force(contactDots(contact, size)), impulse(force)
    {
    }
};

}  // namespace

FigureData sceneResponseFigure(const answers::SceneResponse& response)
{
    if (response.frequencies.empty()) {
        throw std::invalid_argument("figure: the response holds no frequency to draw");
    }
    double force = 0.0;
    double impulse = 0.0;
    for (const SceneFrequency& at : response.frequencies) {
        for (const SceneHarmonicMotion& motion : at.motions) {
            force = std::max(force, forceOf(motion));
            impulse = std::max(impulse, impulseOf(motion));
        }
    }
    const Unit forceUnit = unitFor(force, "N");
    const Unit impulseUnit = unitFor(impulse, "N s");
    const double low = response.frequencies.back().hertz;
    const double high = response.frequencies.front().hertz;
    constexpr double large = 0.8;
    constexpr double small = 0.25;  // of what repels
    std::vector<std::array<ContactDots, 2>> contacts;
    for (std::size_t contact = 0; contact < response.bars.contacts.size(); ++contact) {
        contacts.push_back({ContactDots(contact, large), ContactDots(contact, small)});
    }
    Series open = line(Role::faint, 2.4);
    Series unknown = dots(Role::ink, 0.8, Marker::cross);
    for (const SceneFrequency& at : response.frequencies) {
        at.touches() || at.reason ? open.breakOff() : open.add(at.hertz, 0.0);
        if (at.motions.empty() && (at.touches() || at.reason)) {
            unknown.add(at.hertz, 0.0);
        }
        for (const SceneHarmonicMotion& motion : at.motions) {
            ContactDots& dots = contacts[motion.value.contact][motion.attracts() == false ? 1 : 0];
            dots.force.add(at.hertz, forceOf(motion) * forceUnit.factor);
            dots.impulse.add(at.hertz, impulseOf(motion) * impulseUnit.factor);
        }
    }
    FigureData figure;
    figure.title = fmt::format(
        "{} of amplitude {},  {}", response.range.place == Excited::tip ? "force" : "moving base",
        withUnit(response.range.amplitude,
                 amplitudeUnitName(response.range.place, response.range.derivative)),
        response.range.isExact ? "exact harmonic" : "harmonic in steps");
    figure.height = 14.0;
    const double margin = high > low ? 0.02 * (high - low) : 0.02 * high;
    Axis x = hertzAxis(low - margin, high + margin, answers::firstHertz(response.bars.reference));
    Panel upper{.name = "force", .place = {0.12, 0.95, 0.56, 0.85}};
    upper.x = bare(x);
    upper.x.other = std::exchange(x.other, {});
    upper.y = {.label = labelled("largest force", forceUnit),
               .low = 0.0,
               .high = std::max(1.15 * force * forceUnit.factor, 1e-9)};
    Panel lower{.name = "impulse", .place = {0.12, 0.95, 0.25, 0.52}, .legend = Legend::below};
    lower.legendRows = 2 + static_cast<int>(contacts.size());
    for (const auto& dots : contacts) {
        lower.legendRows += dots[1].force.x.empty() ? 0 : 1;
    }
    lower.x = x;
    lower.y = {.label = labelled("impulse per period", impulseUnit),
               .low = 0.0,
               .high = std::max(1.15 * impulse * impulseUnit.factor, 1e-9)};
    const auto put = [&](Series above, const Series& below, std::string words) {
        upper.add(std::move(above));
        lower.add(below.named(std::move(words)));
    };
    put(open, open, "bars that do not meet");
    for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
        auto& [usual, repelling] = contacts[contact];
        put(std::move(usual.force), usual.impulse, fmt::format("contact {}", contact + 1));
        put(std::move(repelling.force), repelling.impulse,
            fmt::format("contact {}, repels", contact + 1));
    }
    put(unknown, unknown, "they would, and no motion with one contact is known");
    figure.panels = {std::move(upper), std::move(lower)};
    return figure;
}

}  // namespace signorini
