#pragma once
/// \file
/// What is said of bars in a row whose excitation is an exact harmonic.

#include "harmonic_answer.hpp"
#include "harmonic_network_walk.hpp"
#include "scene_find_answer.hpp"

namespace signorini::answers {

/// The period that a call asks of bars, in which an excitation goes through so many cycles: whole
/// steps for a period, the nearest for a frequency [omega_1 of these bars]. \throws
/// std::invalid_argument naming it and what is allowed.
[[nodiscard]] AskedPeriod askedOfBars(const Call& call, const Assembly& assembly,
                                      std::int64_t cycles);

/// One of its contacts.
struct SceneHarmonicContact {
    NetworkHarmonicContact value;
    NetworkScales scales;
};

/// One motion, and what its units are in SI.
struct SceneHarmonicMotion {
    NetworkHarmonicMotion value;
    NetworkScales scales;
    /// Under a staircase of forces, whose motions have no harmonic waves.
    struct InSteps {
        bool opens = true;
        std::optional<SceneStability> stability = {};  ///< where it was asked for
        std::vector<ContactSpan> spans = {};           ///< of two contacts in a period
        double amplitude = 0.0;                        ///< [N] or [m], of these
    };
    SceneStrains strains = {};
    std::optional<InSteps> inSteps = {};

    [[nodiscard]] double compression() const { return strains.compression; }
    /// Does it come back when it is disturbed? As growth says, or as was tried under a staircase;
    /// nothing where neither tells.
    [[nodiscard]] std::optional<bool> attracts() const;
    /// Of one under an exact harmonic.
    [[nodiscard]] std::optional<std::vector<SceneHarmonicContact>> contacts() const;
    [[nodiscard]] bool hasTwoContacts() const { return value.contacts.size() == 2; }
    /// What such a motion has of its own under a staircase.
    template <typename Member>
    [[nodiscard]] auto ofTwo(Member member) const
    {
        return inSteps && hasTwoContacts() ? std::optional((*inSteps).*member) : std::nullopt;
    }
    [[nodiscard]] const char* release() const
    {
        return !inSteps ? releaseOf(value.first()) : inSteps->opens ? "step" : "never";
    }
};

/// The motions with one contact in a period of n steps, or with several the one on which bars at
/// rest settle.
struct SceneHarmonicAnswer {
    Excited place;
    std::int64_t cycles;  ///< of the excitation in a period
    double amplitude;     ///< [N] or [m]
    std::int64_t steps;   ///< n
    NetworkScales scales;
    SeveralBars bars;
    std::int64_t contacts;                     ///< in a period
    std::vector<SceneHarmonicMotion> motions;  ///< by ascending impulse
    std::int64_t settledContacts = 0;          ///< of what bars at rest settled on, if it was asked
    std::int64_t settledCycles = 0;            ///< the period of that
    HarmonicLimit limit = {};
    AskedPeriod asked = {};
    /// Does momentum allow a contact to press? Constant forces on bars that drift may not.
    bool mayPress = true;

    [[nodiscard]] Status status() const
    {
        return !motions.empty() ? Status::found : mayPress ? Status::undecided : Status::none;
    }
    [[nodiscard]] double period() const { return static_cast<double>(steps) * scales.time; }
    /// Of the excitation [Hz].
    [[nodiscard]] double frequency() const { return static_cast<double>(cycles) / period(); }
    [[nodiscard]] std::optional<double> frequencyRatio() const;
    [[nodiscard]] QuestionPart question() const;
    /// What was asked, in units of the network.
    [[nodiscard]] HarmonicNetwork given() const;
    /// Looks at a motion over one period; what it is told includes the shape under constant forces.
    /// \throws std::out_of_range.
    void watch(std::size_t motion, const HarmonicWatch& by) const;
    [[nodiscard]] std::optional<std::string> detail() const;
};

/// With what is measured of it, in SI.
[[nodiscard]] SceneHarmonicMotion motionOf(const Assembly& assembly, const NetworkScales& scales,
                                           NetworkHarmonicMotion motion);

/// What a call asks of bars. \throws std::invalid_argument on options that are missing or do not go
/// together.
[[nodiscard]] Question<SceneHarmonicAnswer> harmonicAsked(const Call& call,
                                                          const Assembly& assembly);

/// Of an amplitude [N or m], or of a derivative of the base's displacement [m/s, m/s^2].
/// \throws as harmonicContacts (harmonic_network_contact.hpp), or of several contacts as
/// settledHarmonic (harmonic_network_settled.hpp).
[[nodiscard]] SceneHarmonicAnswer answerOf(const Assembly& assembly, Excited place,
                                           std::int64_t cycles, std::int64_t steps,
                                           double amplitude, int derivative,
                                           std::int64_t contacts = 1, const Cancel& cancel = {});

void describe(auto& d, Type<SceneHarmonicContact>)
{
    using C = NetworkHarmonicContact;
    const auto inUnit = [](auto member, auto unit) {
        return [member, unit](const SceneHarmonicContact& c) {
            return std::invoke(member, c.value) * std::invoke(unit, c.scales);
        };
    };
    d.record("SceneHarmonicContact", "One contact of bars under an exact harmonic.");
    d.key("contact", "- >= 1", "Which.",
          [](const SceneHarmonicContact& c) { return c.value.contact + 1; });
    d.key("begin", "s >= 0", "From the start of the first contact.",
          inUnit(&C::begin, &NetworkScales::time));
    d.key("end", "s > 0", "The release.", inUnit(&C::end, &NetworkScales::time));
    d.key("begin_steps", "- >= 0", "The same in steps.", ofValue(&C::begin));
    d.key("end_steps", "- > 0", "The same in steps.", ofValue(&C::end));
    d.key("release", "-", R"("smooth": the push fades to 0; "pinned": a wave front ends it.)",
          ofValue(&releaseOf<C>));
    d.key("impulse", "N s > 0", "Of its push.", [](const SceneHarmonicContact& c) {
        return c.value.impulse * c.scales.force() * c.scales.time;
    });
    d.key("peak_force", "N > 0", "Largest.", inUnit(&C::peakForce, &NetworkScales::force));
    d.key("speed", "m/s >= 0", "With which it closes.",
          inUnit(&C::speed, &NetworkScales::velocity));
}

void describe(auto& d, Type<SceneHarmonicMotion>)
{
    using T = SceneHarmonicMotion;
    d.record("SceneHarmonicMotion",
             "One motion of bars under a harmonic; contact is at any times, under a staircase of "
             "forces at whole steps.");
    d.key("contact", "- >= 1", "The one that closes; of several the first.",
          [](const T& m) { return m.value.first().contact + 1; });
    d.key("contact_time", "s > 0", "In a period.",
          [](const T& m) { return m.value.contactTime() * m.scales.time; });
    d.key("contact_steps", "- > 0", "The same in steps.",
          ofValue(&NetworkHarmonicMotion::contactTime));
    d.key(
        "release", "-",
        R"("smooth": the push fades to 0; "pinned": a wave front ends it; under a staircase "step", )"
        R"(or "never": the contact does not open.)",
        &T::release);
    d.key("phase", "rad", "Of the excitation at the start of contact.",
          ofValue(&NetworkHarmonicMotion::phase));
    d.key("impulse", "N s >= 0",
          "Of its contacts in a period: 0 of those that a force in steps only touches.",
          [](const T& m) { return m.value.impulse * m.scales.force() * m.scales.time; });
    d.key("peak_force", "N >= 0", "Largest.",
          [](const T& m) { return m.value.peakForce * m.scales.force(); });
    d.key("speed", "m/s >= 0", "Largest with which a contact closes.",
          [](const T& m) { return m.value.speed * m.scales.velocity(); });
    d.key("growth", "- > 0",
          "Of a small disturbance in a period, under an exact harmonic; nothing where it is not "
          "known.",
          ofValue(&NetworkHarmonicMotion::growth));
    d.key("attracts", "-",
          "Do bars that are disturbed a little come back? As growth says, or under a staircase as "
          "was tried; nothing where neither tells.",
          &T::attracts);
    d.key("residual", "- >= 0", "The worst that was seen moving its waves by the law; relative.",
          ofValue(&NetworkHarmonicMotion::residual));
    d.key("strains", "-", "In a period.", &T::strains);
    d.key("admissible", "-", "Is s > -1 everywhere?",
          [](const T& m) { return m.compression() < 1.0; });
    d.key("contacts", "-", "In a period, as they follow each other, under an exact harmonic.",
          &T::contacts, When::any);
    d.key(
        "stability", "-", "Of the motion when it is perturbed.",
        [](const T& m) { return m.inSteps ? m.inSteps->stability : std::nullopt; }, When::any);
    d.key(
        "spans", "-", "Of two contacts in a period, from the start of the first.",
        [](const T& m) { return m.ofTwo(&T::InSteps::spans); }, When::any);
    d.key(
        "amplitude", "N or m > 0", "Of its excitation, where it has two contacts.",
        [](const T& m) { return m.ofTwo(&T::InSteps::amplitude); }, When::any);
}

void describe(auto& d, Type<SceneHarmonicAnswer>)
{
    using T = SceneHarmonicAnswer;
    d.record("SceneHarmonicResult",
             "Motions of bars in a row with one contact in a period, under an exact harmonic; of "
             "several contacts that on which bars at rest settle.");
    d.key(
        "status", "-",
        R"("found", "undecided", or "none" where no push gives bars that drift their momentum back.)",
        &T::status);
    describeQuestion(d, &T::question);
    d.key("contacts_in_period", "- >= 1", "That were asked for.", &T::contacts);
    d.key("force", "-", "What is excited: driven nodes (tip), or shaken clamps (base).", &T::place);
    d.key("cycles", "- >= 1", "Of the excitation in a period.", &T::cycles);
    d.key("amplitude", "N or m > 0", "Of the excitation.", &T::amplitude);
    d.key("steps", "- >= 2", "Of the period.", &T::steps);
    d.key("period", "s > 0", "T.", &T::period);
    d.key("frequency", "Hz > 0", "Of the excitation.", &T::frequency);
    d.key("frequency_ratio", "- > 0", "The same in omega_1 of these bars, if they vibrate.",
          &T::frequencyRatio);
    d.key("motions", "-", "By ascending impulse.", &T::motions);
    describeLimit(d, &T::limit);
    describeBarsAndContacts(d, &T::bars);
    d.key("detail", "-", "Why there is none, or it is not decided.", &T::detail, When::undecided);
}

}  // namespace signorini::answers
