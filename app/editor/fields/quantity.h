/// What an expression computes with: a plain number and degrees, kept apart so that "sin(30 deg)" is exactly a half.
#pragma once

#include <string_view>

namespace batten::editor {

/// The sum of a plain number and an angle; the angle is `degrees` π/180 as a number.
struct Quantity {
    double plain = 0.0;
    double degrees = 0.0;
};

/// The quantity as a number; an angle in radians.
double in_radians(Quantity quantity);

/// The quantity as an angle in degrees, of which a plain number is one too.
double in_degrees(Quantity quantity);

Quantity operator+(Quantity a, Quantity b);
Quantity operator-(Quantity a);
/// Also of two angles, as radians.
Quantity operator*(Quantity a, Quantity b);
/// Of two angles their ratio. Not finite when `b` is 0.
Quantity operator/(Quantity a, Quantity b);

/// A function of one number by its name in lower case, such as "sqrt"; null for any other name.
using QuantityFunction = Quantity (*)(Quantity);
QuantityFunction quantity_function(std::string_view name);

}  // namespace batten::editor
