#include "lambda_images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "axes.hpp"
#include "curve_points.hpp"

namespace signorini {

namespace {

using namespace plot;

constexpr std::size_t mostRows = 160;
constexpr std::size_t mostColumns = 400;
constexpr std::array memberNames{"first", "middle", "last"};
constexpr std::array lefts{0.1, 0.41, 0.73};

/// The longest profile, without the zeros at its end.
std::size_t lengthOf(const Profiles& profiles)
{
    std::size_t pieces = 0;
    for (const std::vector<double>& profile : profiles) {
        const auto last = std::find_if(profile.rbegin(), profile.rend(),
                                       [](double value) { return value != 0.0; });
        pieces = std::max(pieces, static_cast<std::size_t>(profile.rend() - last));
    }
    return pieces > 0 ? pieces : profiles.front().size();
}

}  // namespace

LambdaImages::LambdaImages(std::vector<double> lambdas, std::string label)
    : lambdas_(std::move(lambdas)), label_(std::move(label))
{
    if (lambdas_.empty()) {
        throw std::invalid_argument("figure: the curve holds no motion to draw");
    }
    low_ = lambdas_.front();
    high_ = lambdas_.back();
    if (!(high_ > low_)) {
        high_ = low_ + 1.0;
    }
    const std::size_t last = lambdas_.size() - 1;
    for (const std::size_t k : {std::size_t{0}, last / 2, last}) {
        if (full_.empty() || full_.back() != k) {
            full_.push_back(k);
        }
    }
    for (std::size_t row = 0; row < mostRows; ++row) {
        rows_.push_back(low_ + (high_ - low_) * (static_cast<double>(row) + 0.5) / mostRows);
        members_.push_back(nearestTo(rows_.back(), lambdas_));
    }
}

FigureData LambdaImages::figure(std::string title, const std::vector<LambdaImage>& images,
                                const FullMotions& motions) const
{
    FigureData figure{.width = 18.0, .height = 18.0, .title = std::move(title)};
    for (const LambdaImage& image : images) {
        add(figure, image);
    }
    add(figure, motions);
    return figure;
}

void LambdaImages::add(FigureData& figure, const LambdaImage& of) const
{
    const std::size_t column = figure.panels.size();
    const double left = lefts.at(column);
    const std::size_t pieces = lengthOf(of.profiles);
    const std::size_t columns = std::min(pieces, mostColumns);
    const double length = of.width * static_cast<double>(pieces);
    Series image{.kind = Kind::image, .y = rows_};
    double largest = 0.0;
    for (std::size_t i = 0; i < columns; ++i) {
        image.x.push_back(length * (static_cast<double>(i) + 0.5) / static_cast<double>(columns));
    }
    for (const std::vector<double>& profile : of.profiles) {
        for (std::size_t i = 0; i < columns; ++i) {  // the largest of what is too fine for print
            double shown = 0.0;
            for (std::size_t k = i * pieces / columns; k < (i + 1) * pieces / columns; ++k) {
                shown = std::abs(profile[k]) > std::abs(shown) ? profile[k] : shown;
            }
            image.z.push_back(shown);
            largest = std::max(largest, std::abs(shown));
        }
    }
    const Unit unit = axisUnit(of.scale, largest, of.base);
    for (double& value : image.z) {
        value *= unit.factor;
    }
    Panel& panel = figure.add({.name = of.name, .place = {left, left + 0.19, 0.54, 0.89}});
    panel.title = labelled(of.title, unit);
    panel.hasGrid = false;
    panel.x = {.label = of.axis, .low = 0.0, .high = length, .step = niceStep(length / 3.0)};
    panel.y = {.low = low_, .high = high_, .hasNumbers = column == 0};
    if (column == 0) {
        panel.y.label = label_;
    }
    panel.map = ColourMap::diverging;
    panel.colour = {.low = -largest * unit.factor, .high = largest * unit.factor};
    if (!(largest > 0.0)) {
        panel.colour = {.low = -1.0, .high = 1.0};
    }
    panel.colourBar = Place{left + 0.2, left + 0.212, 0.54, 0.89};
    panel.add(std::move(image));
    for (const std::size_t k : full_) {
        panel.add(across(0.0, length, lambdas_[k], 1.0, Dash::dashed));
    }
}

void LambdaImages::add(FigureData& figure, const FullMotions& motions) const
{
    const auto& [along, length, upwards, colours, fields, marks] = motions;
    Axis colour{.label = colours, .low = 0.0, .high = 0.0};
    for (const Series& field : fields) {
        const auto [least, most] = std::minmax_element(field.z.begin(), field.z.end());
        colour.low = std::min(*colour.low, *least);
        colour.high = std::max(*colour.high, *most);
    }
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const double left = 0.1 + 0.265 * static_cast<double>(k);
        Panel& panel =
            figure.add({.name = memberNames.at(k), .place = {left, left + 0.24, 0.08, 0.42}});
        panel.title = fmt::format("λ = {:.4g}", lambdas_[full_[k]]);
        panel.hasGrid = false;
        panel.x = {.label = along, .low = 0.0, .high = length, .step = niceStep(length / 3.0)};
        panel.y = k > 0 ? bare(upwards) : upwards;
        panel.colour = colour;
        panel.add(fields[k]);
        panel.add(marks);
    }
    const double right = figure.panels.back().place.right;
    figure.panels.back().colourBar = Place{right + 0.02, right + 0.035, 0.08, 0.42};
}

}  // namespace signorini
