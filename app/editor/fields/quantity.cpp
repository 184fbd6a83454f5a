#include "app/editor/fields/quantity.h"

#include <array>
#include <cmath>
#include <numbers>

namespace batten::editor {

namespace {

// In long double, so that the usual angles give the nearest double: sin 30° is 0.5.
constexpr long double radians_per_degree = std::numbers::pi_v<long double> / 180.0L;

bool has_no_angle(Quantity quantity) {
    return quantity.degrees == 0.0;
}

bool is_angle(Quantity quantity) {
    return quantity.plain == 0.0 && !has_no_angle(quantity);
}

Quantity of_number(double number) {
    return {number, 0.0};
}

double sine_of_degrees(double degrees) {
    double folded = std::remainder(degrees, 360.0);
    if (std::abs(folded) > 90.0) folded = std::copysign(180.0, folded) - folded;
    return static_cast<double>(std::sin(folded * radians_per_degree));
}

double cosine_of_degrees(double degrees) {
    return sine_of_degrees(90.0 - std::abs(std::remainder(degrees, 360.0)));
}

double sine(Quantity x) {
    return is_angle(x) ? sine_of_degrees(x.degrees) : std::sin(in_radians(x));
}

double cosine(Quantity x) {
    return is_angle(x) ? cosine_of_degrees(x.degrees) : std::cos(in_radians(x));
}

// An arc is an angle: 45 degrees where degrees are needed, 0.785... where a number is.
template <long double (*arc)(long double)>
Quantity arc_of(Quantity x) {
    return {0.0, static_cast<double>(arc(in_radians(x)) / radians_per_degree)};
}

template <double (*function)(double)>
Quantity applied(Quantity x) {
    return of_number(function(in_radians(x)));
}

struct NamedFunction {
    std::string_view name;
    QuantityFunction function;
};

constexpr std::array named_functions{
    NamedFunction{"sqrt", applied<std::sqrt>},
    NamedFunction{"sin", [](Quantity x) { return of_number(sine(x)); }},
    NamedFunction{"cos", [](Quantity x) { return of_number(cosine(x)); }},
    NamedFunction{"tan", [](Quantity x) { return of_number(sine(x) / cosine(x)); }},
    NamedFunction{"asin", arc_of<std::asin>},
    NamedFunction{"acos", arc_of<std::acos>},
    NamedFunction{"atan", arc_of<std::atan>},
    NamedFunction{"exp", applied<std::exp>},
    NamedFunction{"ln", applied<std::log>},
    NamedFunction{"abs", [](Quantity x) { return in_radians(x) < 0.0 ? -x : x; }},
};

}  // namespace

double in_radians(Quantity quantity) {
    return quantity.plain + static_cast<double>(quantity.degrees * radians_per_degree);
}

double in_degrees(Quantity quantity) {
    return quantity.plain + quantity.degrees;
}

Quantity operator+(Quantity a, Quantity b) {
    return {a.plain + b.plain, a.degrees + b.degrees};
}

Quantity operator-(Quantity a) {
    return {-a.plain, -a.degrees};
}

Quantity operator*(Quantity a, Quantity b) {
    if (has_no_angle(b)) return {a.plain * b.plain, a.degrees * b.plain};
    if (has_no_angle(a)) return b * a;
    return of_number(in_radians(a) * in_radians(b));
}

Quantity operator/(Quantity a, Quantity b) {
    if (has_no_angle(b)) return {a.plain / b.plain, has_no_angle(a) ? 0.0 : a.degrees / b.plain};
    if (is_angle(a) && is_angle(b)) return of_number(a.degrees / b.degrees);
    return of_number(in_radians(a) / in_radians(b));
}

QuantityFunction quantity_function(std::string_view name) {
    for (const NamedFunction& known : named_functions)
        if (known.name == name) return known.function;
    return nullptr;
}

}  // namespace batten::editor
