#pragma once
/// \file
/// Words of the command line turned into numbers, with one line of text when they are wrong.

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "call.hpp"
#include "faults.hpp"
#include "names.hpp"
#include "signorini/assembly.hpp"
#include "signorini/bar.hpp"
#include "signorini/bar_pieces.hpp"
#include "signorini/find_periodic.hpp"
#include "signorini/schedule.hpp"
#include "simulation_answer.hpp"

namespace signorini::cli {

class Given;

/// Exit status of the program.
enum ExitStatus : int {
    exitFound = 0,        ///< found / done
    exitNone = 1,         ///< proved: none exists
    exitWrongUse = 2,     ///< an argument is wrong; nothing was written
    exitUndecided = 3,    ///< prevented by a limit or by rounding
    exitUnavailable = 4,  ///< a file, database or back end could not be used
};

/// The exit status that tells a verdict, or whether work came to its end.
[[nodiscard]] ExitStatus exitStatusOf(Status status);
[[nodiscard]] ExitStatus exitStatusOf(answers::Ending ending);

/// Writes to standard output, whole or with an error. \throws FileError.
void writeOut(std::string_view text);

/// Words for people, to standard error. Where they cannot be written they are lost, not the work.
void tell(std::string_view text) noexcept;

/// Stops the removal of temporary files from being skipped when a signal ends the program: files
/// staged later under `path` are removed by the handlers of SIGINT, SIGTERM and SIGHUP.
void removeOnSignal(const std::string& path);

using answers::refuse;
using answers::refuseIf;

using answers::GivenNumber;
using answers::parseFraction;
using answers::parseNumber;
using answers::parsePositive;
using answers::parseRatio;

using answers::ForceOptions;
using answers::FrequencyOption;
using answers::givenEnd;
using answers::hinting;
using answers::requireOrder;
using answers::yieldStressOf;

/// A whole number in [low, high]. \throws std::invalid_argument naming argument, value and range.
[[nodiscard]] std::int64_t parseWhole(std::string_view name, std::string_view text,
                                      std::int64_t low, std::int64_t high);

/// A finite number, plain or with its unit (units.hpp). \throws std::invalid_argument naming
/// argument, value and range.
[[nodiscard]] double parseReal(std::string_view name, std::string_view text, std::string_view unit);

/// The options every command shares.
struct CommonOptions {
    explicit CommonOptions(const Given& given);

    std::string_view command;
    std::optional<std::int64_t> cells;
    bool choosesCells;  ///< --cells auto
    bool wantsJson;
    bool quiet;
    bool isVerbose;
    std::int64_t threads;
    std::string progressFile;
    std::string sceneText;  ///< of --scene: words, or the name of a file; empty: not given
    double gravity;         ///< [m/s^2], to the right along all bars
    std::optional<double> dampingRatio;  ///< of a bar that is no --scene

    /// Those given, or those of all segments, or 300.
    [[nodiscard]] std::int64_t usualCells() const;
    /// For commands that know a uniform bar and any stops. \throws as scene, on segments.
    [[nodiscard]] Scene sceneOfOneBar() const;
    /// For commands that know a uniform bar and one wall. \throws std::invalid_argument on a clash,
    /// numbers that do not go together, or a scene with more.
    [[nodiscard]] Bar bar() const;
    /// Blames the weight for a gap that is not fit. \throws std::invalid_argument.
    void requireGap(const Bar& bar, bool isFit) const;
    /// The same for commands that know gaps of any sign.
    [[nodiscard]] Bar barOfAnyGap() const;
    /// The short forms, or (scene_options.cpp) a --scene that is a bar with stops at its tip; under
    /// gravity what it is about its rest.
    /// \throws std::invalid_argument on a clash, numbers that do not go together, or a --scene that
    /// is more; FileError.
    [[nodiscard]] Scene scene() const;
    /// --gap, --second-stop, --segments and --segments-file, whatever --scene says.
    /// \throws std::invalid_argument as `scene`.
    [[nodiscard]] Scene shortForms() const;
    /// [m/s^2], that of a --scene file or the option.
    [[nodiscard]] double weight() const { return hasScene() ? assembly().gravity : 0.0; }
    /// Are bars in a row meant: --scene, or the short forms under gravity?
    [[nodiscard]] bool hasScene() const { return !sceneText.empty() || gravity != 0.0; }
    /// What --scene says, or the short forms as a scene. \throws std::invalid_argument on words
    /// that are no scene, or options that clash with them; FileError.
    [[nodiscard]] const Assembly& assembly() const;
    /// \throws std::invalid_argument where --damping stands beside --scene.
    void requireOwnDamping() const;
    /// The line with which an answer in words begins: the bar that was meant, so that a wrong or
    /// forgotten option is seen. With cells and damping where they are part of the question.
    [[nodiscard]] std::string restated(std::optional<std::int64_t> grid = {},
                                       std::optional<double> damping = {}) const;
    /// Words for people, to standard error, unless they are not wanted.
    void say(std::string_view what) const;
    /// That no file was written, and why.
    void sayNoFile(std::string_view why) const
    {
        say(fmt::format("{}, so no file was written", why));
    }
    /// Says that a motion breaks the paper's condition, if it does.
    void warnUnlessAdmissible(const Physical& physical) const;
    /// For a command that works on one thread: says so where more were allowed. Said last, so that
    /// a wrong call stays one line.
    void useOneThread() const;

private:
    /// What --segments-file says. \pre it is given.
    [[nodiscard]] const PiecedBar& pieces() const;

    std::string piecesFile_;
    mutable std::optional<PiecedBar> pieces_;  ///< kept: files may be pipes
    mutable std::optional<Assembly> assembly_;
    std::optional<double> secondStop_;
    std::vector<Segment> segments_;
    const Given* given_;
};

/// "150:1,150:1.3:1": cells, impedance and speed, of one segment after the other.
/// \throws std::invalid_argument naming argument, value and range.
[[nodiscard]] std::vector<Segment> parseSegments(std::string_view name, std::string_view text);

/// NC NF [L:NC NF ...], L: before the contact on the second stop. \throws std::invalid_argument on
/// a wrong value or an odd number of words.
[[nodiscard]] std::vector<Phase> parsePhases(const std::vector<std::string>& words);

}  // namespace signorini::cli
