/// Numbers of one quantity that stand together: all with the same decimals, so that they can be compared at a glance.
#pragma once

#include <span>
#include <string>

#include "core/curve/curve.h"

namespace batten::editor {

/// How the numbers of a column are written.
struct NumberColumn {
    int decimals = 0;
    bool is_plain = true;  ///< false where the largest one is too large or too small for decimals

    bool operator==(const NumberColumn&) const = default;
};

/// The column for `values`: six significant digits of the largest one, less the zeros at the end that all of them have.
NumberColumn column_for(std::span<const double> values);

/// `value` in its column. What its decimals would show as zero, but is not, gets significant digits of its own.
std::string column_text(double value, NumberColumn column);

/// The same without zeros at the end, for a number by itself.
std::string lone_text(double value, NumberColumn column);

/// Decimals that tell positions apart in something of extent `size` (> 0): three to four significant digits of it.
int decimals_for(double size);

/// A parameter of `curve`, and a position on or beside a curve whose control points fill a box with a longer side of
/// `size`, with the decimals that they have everywhere on screen.
std::string parameter_text(const core::Curve& curve, double u);
std::string place_text(double size, core::Point place);

/// Weights from here on are written by themselves.
inline constexpr double great_weight = 1000.0;

/// The weights of `curve`, written alike. A weight counts by its ratio to others, so that each keeps its digits beside
/// a greater one.
NumberColumn weight_column(const core::Curve& curve);

/// A weight by itself, as it is beside its point.
std::string weight_text(double weight, NumberColumn column);

}  // namespace batten::editor
