#pragma once
/// \file
/// Curves of motions as images: λ upwards, a row for each motion.

#include <string>
#include <vector>

#include "signorini/figure_data.hpp"

namespace signorini {

/// A number of each cell or step, for each motion that is shown.
using Profiles = std::vector<std::vector<double>>;

/// What is said of an image.
struct ImageWords {
    const char* name;   ///< of its panel
    std::string axis;   ///< of its abscissa, with the unit
    std::string title;  ///< without the unit
    double scale;       ///< what 1 of the profiles is in SI
    const char* base;   ///< unit, "N"
};

class LambdaImages {
public:
    /// Of points at these lambdas, ascending. `label`: of the ordinate.
    /// \throws std::invalid_argument without points.
    LambdaImages(std::vector<double> lambdas, std::string label);

    /// Which points are shown, row by row: those nearest to it.
    [[nodiscard]] const std::vector<std::size_t>& members() const { return members_; }
    /// Which are to be drawn in full: first, middle, last. Each image marks them.
    [[nodiscard]] const std::vector<std::size_t>& full() const { return full_; }

    /// A third of the upper half: the `column`th. Pieces are so wide, in units of the axis; zeros
    /// at the end of all are left out.
    void add(plot::FigureData& figure, int column, const Profiles& profiles, double width,
             const ImageWords& words) const;
    /// A third of the lower half, for a motion that is drawn in full, over so long an axis `along`.
    /// The panel's field is the caller's; all of these are to share one scale of colours.
    [[nodiscard]] plot::Panel& addFull(plot::FigureData& figure, std::size_t which,
                                       const std::string& along, double length,
                                       plot::Axis upwards) const;
    /// One scale of colours for all of them, beside the last.
    void shareColours(plot::FigureData& figure, const std::string& label) const;

private:
    std::vector<double> lambdas_;
    std::string label_;
    double low_ = 0.0;
    double high_ = 0.0;
    std::vector<std::size_t> full_;
    std::vector<double> rows_;  ///< λ
    std::vector<std::size_t> members_;
};

}  // namespace signorini
