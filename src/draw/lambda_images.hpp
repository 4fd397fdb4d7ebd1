#pragma once
/// \file
/// Curves of motions as images: λ upwards, a row for each motion.

#include <string>
#include <vector>

#include "signorini/figure_data.hpp"

namespace signorini {

/// A number of each cell or step, for each motion that is shown.
using Profiles = std::vector<std::vector<double>>;

/// An image of the upper half: λ upwards, a row for each motion.
struct LambdaImage {
    const char* name;        ///< of its panel
    std::string axis;        ///< of its abscissa, with the unit
    std::string title;       ///< without the unit
    double scale;            ///< what 1 of the profiles is in SI
    const char* base;        ///< unit, "N"
    double width;            ///< of a piece, in units of the axis
    Profiles profiles = {};  ///< zeros at the end of all are left out
};

/// Motions in full in the lower half, side by side: u upwards in time, to one scale of colours.
struct FullMotions {
    std::string along;  ///< words of the abscissa
    double length;      ///< its end
    plot::Axis upwards;
    std::string colours;
    std::vector<plot::Series> fields = {};
    plot::Series marks = plot::strokes(plot::Role::ink, 0.8);  ///< on each of them
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

    /// Three images, and the motions in full.
    [[nodiscard]] plot::FigureData figure(std::string title, const std::vector<LambdaImage>& images,
                                          const FullMotions& motions) const;

private:
    void add(plot::FigureData& figure, const LambdaImage& of) const;
    void add(plot::FigureData& figure, const FullMotions& motions) const;

    std::vector<double> lambdas_;
    std::string label_;
    double low_ = 0.0;
    double high_ = 0.0;
    std::vector<std::size_t> full_;
    std::vector<double> rows_;  ///< λ
    std::vector<std::size_t> members_;
};

}  // namespace signorini
