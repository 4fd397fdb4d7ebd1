#pragma once
/// \file
/// Two quantities of the same motions, one panel above the other over one axis.

#include <string>

#include "signorini/figure_data.hpp"

namespace signorini {

/// A quantity that is drawn from 0 upwards.
struct Upwards {
    std::string words;
    const char* base;        ///< its unit in SI
    double scale = 1.0;      ///< [base], of 1 on the other side; the axis of nothing ends there
    std::string other = {};  ///< words of the other side; empty: it has none
    double room = 1.15;      ///< the end of the axis over the largest
    double largest = 0.0;    ///< [base], so far
};

/// The same points in both panels, in SI.
struct SeriesPair {
    plot::Series above;
    plot::Series below;

    explicit SeriesPair(const plot::Series& style) : above(style), below(style) {}
    void add(double x, double upper, double lower);
    void breakOff();
};

struct TwoPanels {
    plot::Panel upper;  ///< has the legend, unless that of the lower one stands below
    plot::Panel lower;
    Upwards above;
    Upwards below;

    /// Nothing if both are empty; a measure is seen as a whole, all else as far as there is room.
    void add(SeriesPair pair, const std::string& words = {}, bool isMeasure = true);
    /// In units for their sizes. The other side of x stands on top.
    [[nodiscard]] FigureData figure(std::string title, const plot::Axis& x) &&;
};

}  // namespace signorini
