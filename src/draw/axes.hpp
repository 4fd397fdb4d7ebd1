#pragma once
/// \file
/// Axes for people: engineering units and round steps.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "signorini/bar.hpp"
#include "signorini/figure_data.hpp"

namespace signorini {

/// A unit of engineers: a value in SI times `factor` is in it.
struct Unit {
    double factor;
    std::string name;  ///< as gnuplot writes it: "mm", "10^{-6}"
};

/// The unit in which `largest` >= 0 is a number from 1 to below 1000: of `base` "m", the
/// millimetre for 0.002; of the pure number "", 10^{-3}.
[[nodiscard]] Unit unitFor(double largest, const std::string& base);

/// 0.001, "m" -> "1 mm"; 0.001, "" -> "1·10^{-3}".
[[nodiscard]] std::string withUnit(double value, const std::string& base);

/// "E/E_1 = 20", or without a gap, where there is no E_1, "E = 2 mJ".
[[nodiscard]] std::string energyLabel(const Bar& bar, double energyRatio);

/// The least of 1, 2, 5 times a power of ten that is not below `least` > 0.
[[nodiscard]] double niceStep(double least);

/// From numbers of which 1 is `scale` in SI to an axis that shows `largest` of them at the most.
[[nodiscard]] Unit axisUnit(double scale, double largest, const std::string& base);

/// "impulse", mN s -> "impulse  [mN s]".
[[nodiscard]] std::string labelled(const std::string& words, const Unit& unit);

/// An axis in `unit` from `low` to `high` of its numbers; on the other side, if it has words, the
/// numbers themselves.
[[nodiscard]] plot::Axis axisIn(const Unit& unit, const std::string& words, double low, double high,
                                const std::string& other = {});

/// An axis on which none of the series runs along the frame; up from 0 if `isFromZero`.
[[nodiscard]] plot::Axis axisAround(const std::vector<plot::Series>& series,
                                    const std::string& label, bool isFromZero = false);

/// Ticks of a logarithmic axis: `digits` times each power of ten, from low > 0 to high.
[[nodiscard]] std::vector<plot::Tick> roundTicks(double low, double high,
                                                 std::initializer_list<double> digits);

/// Energies on a logarithmic axis, with few decades as 1, 2, 5, 10.
[[nodiscard]] plot::Axis energyAxis(const std::string& label, double low, double high);

/// The same axis without words and numbers, beside a panel that has them.
[[nodiscard]] plot::Axis bare(plot::Axis axis);

/// An axis of frequency ratios ω/ω_1, above it Hz.
[[nodiscard]] plot::Axis frequencyAxis(const std::string& words, double low, double high,
                                       const Bar& bar);
/// The same in Hz, above it ratios, where bars vibrate: first > 0.
[[nodiscard]] plot::Axis hertzAxis(double low, double high, double first);

/// Dots of a contact, 0 the first: one look for each; with many they repeat.
[[nodiscard]] plot::Series contactDots(std::size_t contact, double size);

}  // namespace signorini
