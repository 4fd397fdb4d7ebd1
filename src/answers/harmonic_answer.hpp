#pragma once
/// \file
/// What is said of a period whose excitation is an exact harmonic.

#include <functional>

#include "call.hpp"
#include "harmonic_complete.hpp"
#include "parts.hpp"

namespace signorini::answers {

/// What is 0 is not known.
[[nodiscard]] inline std::optional<double> positive(double value)
{
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

using HarmonicContactOf = Of<HarmonicContact>;

/// "pinned", or "smooth": of a contact, or of a motion with one.
[[nodiscard]] const char* releaseOf(const auto& contact)
{
    return contact.isPinned ? "pinned" : "smooth";
}

/// A limit on strain that was asked for.
struct HarmonicLimit {
    std::optional<double> strain = {};  ///< [-], strain >= -strain
    std::int64_t beyond = 0;  ///< motions that do not stay within it, which are not listed

    /// Why none is listed; nothing where it is not for the limit.
    [[nodiscard]] std::optional<std::string> detail() const;
};

/// An answer with only those motions that stay within a limit on strain [-], if one is given.
template <typename Answer>
[[nodiscard]] Answer within(const std::optional<double>& strain, Answer answer)
{
    answer.limit.strain = strain;
    if (strain) {
        const double most = *strain * (1.0 + harmonicTolerance);
        answer.limit.beyond = static_cast<std::int64_t>(std::erase_if(
            answer.motions, [most](const auto& motion) { return motion.compression() > most; }));
    }
    return answer;
}

/// What somebody at rest settles on, where it is not what was asked for; 0: nothing that was seen.
[[nodiscard]] std::string settledDetail(std::string_view who, std::int64_t contacts,
                                        std::int64_t cycles);

/// One motion, and what gives it units.
struct HarmonicMotionOf {
    HarmonicMotion value;
    Bar bar;
    std::optional<double> growth;       ///< [-], of a disturbance in a period, if it is known
    HarmonicProof proof = {};           ///< with enclosed numbers
    std::optional<bool> attracts = {};  ///< as growth says and as was tried

    [[nodiscard]] Physical physical() const { return physicalOf(value.extremes, bar); }
    [[nodiscard]] double compression() const { return physical().peakCompression; }
};

/// All motions with one contact, or with several the one on which a bar at rest settles.
struct HarmonicAnswer {
    ExactPeriod period;  ///< [L/c], of the motion
    Damping damping;
    Excited place;
    std::int64_t cycles;  ///< of the excitation in it
    double amplitude;     ///< [N] or [m]
    Scene scene;
    Bar bar;                                ///< whose scales the answer has
    std::int64_t contacts;                  ///< in a period
    std::vector<HarmonicMotionOf> motions;  ///< by ascending impulse
    std::int64_t settledContacts = 0;       ///< of what a bar at rest settled on, if it was asked
    std::int64_t settledCycles = 0;         ///< the period of that

    HarmonicCompleteness all = {};  ///< of motions with one contact
    HarmonicLimit limit = {};
    AskedPeriod asked = {};

    /// Found, or none if that is proved; which strains motions have is computed.
    [[nodiscard]] Status status() const
    {
        return !motions.empty()                         ? Status::found
               : all.flight == 0.0 && limit.beyond == 0 ? Status::none
                                                        : Status::undecided;
    }
    /// omega/omega_1 of the excitation.
    [[nodiscard]] double frequencyRatio() const
    {
        return 4.0 * static_cast<double>(cycles) / period.value();
    }
    [[nodiscard]] QuestionPart question() const;
    /// [s], of `all`.
    [[nodiscard]] std::optional<double> completeFrom() const;
    [[nodiscard]] std::optional<std::string> detail() const;
    /// What its motions are of.
    [[nodiscard]] HarmonicCase given() const;
    [[nodiscard]] Harmonic excitation() const;
};

/// What a call asks of a bar whose frequencies in Hz are those of so many cells.
/// \throws std::invalid_argument on options that are missing or do not go together.
[[nodiscard]] Question<HarmonicAnswer> harmonicAsked(const Call& call, const Scene& scene,
                                                     std::int64_t cells);

/// \throws as harmonicCase.
[[nodiscard]] HarmonicAnswer answerOf(const ExactPeriod& period, const Damping& damping,
                                      Excited place, std::int64_t cycles, double amplitude,
                                      const Scene& scene, std::int64_t contacts,
                                      const Cancel& cancel = {});

void describe(auto& d, Type<HarmonicContactOf>)
{
    using C = HarmonicContact;
    d.record("HarmonicContact", "One contact under an exact harmonic.");
    d.key("begin", "s >= 0", "From the start of the first contact.",
          ofValue(&C::begin, &Scales::time));
    d.key("end", "s > 0", "The release.", ofValue(&C::end, &Scales::time));
    d.key("begin_ratio", "L/c >= 0", "The same.", ofValue(&C::begin));
    d.key("end_ratio", "L/c > 0", "The same.", ofValue(&C::end));
    d.key("stop", "-", R"("right", or "left".)", ofValue(&C::stop));
    d.key("release", "-", R"("smooth": the push fades to 0; "pinned": a wave front ends it.)",
          ofValue(&releaseOf<HarmonicContact>));
    d.key("impulse", "N s > 0", "Of the stop on the tip.", ofValue(&C::impulse, &impulseUnit));
    d.key("peak_force", "N > 0", "Largest.", ofValue(&C::peakForce, &forceUnit));
    d.key("speed", "m/s >= 0", "Of the tip when it meets the stop.",
          ofValue(&C::speed, &Scales::velocity));
}

void describe(auto& d, Type<HarmonicMotionOf>)
{
    using T = HarmonicMotionOf;
    d.record("HarmonicMotion", "One motion under an exact harmonic; contact is at any times.");
    d.key("contact_time_ratio", "L/c > 0", "In a period.",
          [](const T& m) { return m.value.extremes.contactTime; });
    d.key("release", "-", "Of the first contact.",
          [](const T& m) { return releaseOf(m.value.contacts.front()); });
    d.key("contacts", "-", "In a period, as they follow each other.",
          [](const T& m) { return withUnits(m.value.contacts, m.bar); });
    d.key("phase", "rad", "Of the excitation at the start of contact.",
          ofValue(&HarmonicMotion::phase));
    describePhysical(d, &T::physical);
    d.key("growth", "- > 0",
          "Of a small disturbance in a period; nothing where fronts fade too slowly to tell.",
          &T::growth);
    d.key("attracts", "-",
          "Does a bar that is disturbed a little come back? As growth says and as was tried; "
          "nothing where they disagree, or neither tells.",
          &T::attracts);
    d.key("residual", "- >= 0", "The worst that was seen walking along it; relative.",
          ofValue(&HarmonicMotion::residual));
    d.key("enclosed", "L/c > 0",
          "Enclosed numbers prove that there is a motion so near; nothing where they do not.",
          [](const T& m) { return positive(m.proof.within); });
    d.key("alone_within", "L/c > 0", "So near there is no other with these contacts and fronts.",
          [](const T& m) { return positive(m.proof.aloneWithin); });
}

/// Keys of the limit that a record has.
void describeLimit(auto& d, auto limit)
{
    d.key("strain_limit", "- > 0", "Of all motions listed, if any.",
          partOf(limit)(&HarmonicLimit::strain), When::any);
    d.key("beyond_limit", "- >= 0", "Motions that do not stay within it, not listed.",
          partOf(limit)([](const HarmonicLimit& asked) {
              return asked.strain ? std::optional(asked.beyond) : std::nullopt;
          }),
          When::any);
}

void describe(auto& d, Type<HarmonicAnswer>)
{
    using T = HarmonicAnswer;
    d.record(
        "HarmonicResult",
        "All motions with one contact in a period, under an exact harmonic; of several contacts "
        "that on which a bar at rest settles.");
    d.key("status", "-", R"("found", "none", or "undecided".)", &T::status);
    describeQuestion(d, &T::question);
    d.key("contacts", "- >= 1", "In a period.", &T::contacts);
    d.key("damping", "-", "A dashpot.", [](const T& a) { return Of<Damping>{a.damping, a.bar}; });
    d.key("force", "-", "What is excited.", &T::place);
    d.key("cycles", "- >= 1", "Of the excitation in a period.", &T::cycles);
    d.key("amplitude", "N or m > 0", "Of the excitation.", &T::amplitude);
    d.key("period", "s > 0", "T.",
          [](const T& a) { return a.period.value() * scales(a.bar).time; });
    d.key("period_ratio", "L/c > 0", "c T/L.", [](const T& a) { return a.period.value(); });
    d.key("exact_period", "L/c", "c T/L as a fraction.", &T::period);
    d.key("frequency_ratio", "- > 0", "omega/omega_1 of the excitation.", &T::frequencyRatio);
    d.key("motions", "-", "By ascending impulse.", &T::motions);
    describeLimit(d, &T::limit);
    d.key(
        "complete_from", "s >= 0",
        "Enclosed numbers prove that no motion with one contact is left out that flies as long or "
        "longer, but for those beyond a limit on strain; 0: none at all. Nothing where they do "
        "not, or of several contacts.",
        &T::completeFrom);
    d.key("rests", "-",
          "May the tip, pressed at rest, stay on a stop for good, without a flight? Nothing where "
          "it is too near to tell, or of several contacts.",
          [](const T& a) { return a.all.rests; });
    describeScene(d, &T::scene);
    d.key("detail", "-", "Why it is not decided.", &T::detail, When::undecided);
}

}  // namespace signorini::answers
