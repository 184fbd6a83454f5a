/// How OpenCASCADE measures lengths and writes numbers.
#pragma once

namespace batten::exchange::occt {

/// In millimeters.
inline constexpr double unit_millimeter = 1.0;
inline constexpr double unit_inch = 25.4;

/// Doubles as numbers that read back the same.
inline constexpr const char* all_digits = "%.16E";

}  // namespace batten::exchange::occt
