#pragma once
/// \file
/// Functions that every machine computes alike, to the last bit: C libraries differ there, glibc
/// even from processor to processor, and their bits would show in motions, files and proofs. Here
/// are only operations that IEEE 754 rounds in one way. The series and reductions are those of
/// fdlibm.
///
/// Errors stay below one unit in the last place, 1.5 of `expm1`, 3 of `tanh`, `atan2` and `acos`.

namespace signorini::portable {

[[nodiscard]] double exp(double x);
/// e^x - 1.
[[nodiscard]] double expm1(double x);
/// x > 0.
[[nodiscard]] double log(double x);
/// x^y, x > 0: off by 1 + |y log x| units.
[[nodiscard]] double pow(double x, double y);
/// x >= 0.
[[nodiscard]] double tanh(double x);
/// |x| <= 10^6; beyond, where no phase is, the C library's.
[[nodiscard]] double sin(double x);
/// See `sin`.
[[nodiscard]] double cos(double x);
/// The angle of (x, y), finite; 0 at the origin.
[[nodiscard]] double atan2(double y, double x);
/// |x| <= 1.
[[nodiscard]] double acos(double x);
/// The length of (x, y), also where a square would overflow.
[[nodiscard]] double hypot(double x, double y);

}  // namespace signorini::portable
