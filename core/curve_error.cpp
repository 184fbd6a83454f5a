#include "core/curve_error.h"

#include <array>
#include <charconv>

#include "core/knot_vector.h"

namespace batten::core {

namespace {

// The shortest text that reads back to the same double, whatever the locale.
std::string text(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string text(std::size_t index) {
    return std::to_string(index);
}

std::string item(const char* noun, const CurveError& error) {
    return std::string(noun) + " " + text(error.index);
}

// "one knot", "7 knots"
std::string count(double number, const std::string& noun) {
    return number == 1.0 ? std::string("one ") + noun : text(number) + " " + noun + "s";
}

std::string were_found(double number, const std::string& noun) {
    return count(number, noun) + (number == 1.0 ? " was found" : " were found");
}

std::string is_out_of_range(const char* noun, const CurveError& error) {
    return std::string("there is no ") + item(noun, error) + "; the last one is " + text(error.upper);
}

std::string too_few_points(const CurveError& error) {
    return were_found(error.value, "control point") + "; at least " + text(error.lower) + " are needed";
}

std::string knot_count_mismatch(const CurveError& error) {
    return were_found(error.value, "knot") + "; " + text(error.lower) +
           " are needed, which is points + degree + 1, or points + 1 for a periodic curve";
}

std::string weight_count_mismatch(const CurveError& error) {
    return were_found(error.value, "weight") + " for " + count(error.lower, "control point") +
           "; there must be one for each point, or none at all";
}

std::string knot_decreasing(const CurveError& error) {
    return item("knot", error) + " is " + text(error.value) + ", less than knot " + text(error.index - 1) +
           ", which is " + text(error.lower) + "; knots must not decrease";
}

std::string most_equal_knots(const CurveError& error) {
    return "; at most " + text(error.upper) + " equal knots are allowed there";
}

std::string parameter_outside_domain(const CurveError& error) {
    return "the parameter " + text(error.value) + " is outside the domain; it must be from " + text(error.lower) +
           " to " + text(error.upper);
}

}  // namespace

std::string describe(const CurveError& error) {
    switch (error.code) {
        case CurveErrorCode::degree_out_of_range:
            return "the degree is " + text(error.value) + "; it must be from " + std::to_string(min_degree) + " to " +
                   std::to_string(max_degree);
        case CurveErrorCode::too_few_points:
            return too_few_points(error);
        case CurveErrorCode::knot_count_mismatch:
            return knot_count_mismatch(error);
        case CurveErrorCode::weight_count_mismatch:
            return weight_count_mismatch(error);
        case CurveErrorCode::knot_not_finite:
            return item("knot", error) + " is not a finite number; every knot must be finite";
        case CurveErrorCode::point_not_finite:
            return item("control point", error) +
                   " has a coordinate that is not finite; every coordinate must be finite";
        case CurveErrorCode::weight_not_finite:
            return item("weight", error) + " is not a finite number; every weight must be finite and above 0";
        case CurveErrorCode::weight_not_positive:
            return item("weight", error) + " is " + text(error.value) + "; every weight must be above 0";
        case CurveErrorCode::knot_decreasing:
            return knot_decreasing(error);
        case CurveErrorCode::multiplicity_too_high:
            return item("knot", error) + " occurs " + text(error.value) + " times" + most_equal_knots(error);
        case CurveErrorCode::domain_empty:
            return "the domain begins and ends at " + text(error.value) + "; its end must be above its beginning";
        case CurveErrorCode::parameter_not_finite:
            return "the parameter is not a finite number; it must be finite";
        case CurveErrorCode::parameter_outside_domain:
            return parameter_outside_domain(error);
        case CurveErrorCode::multiplicity_full:
            return "the knot " + text(error.value) + " cannot be inserted that often" + most_equal_knots(error);
        case CurveErrorCode::knot_index_out_of_range:
            return is_out_of_range("knot", error);
        case CurveErrorCode::point_index_out_of_range:
            return is_out_of_range("control point", error);
        case CurveErrorCode::knot_not_removable:
            return item("knot", error) + " cannot be removed; there would be too few control points or no domain";
        case CurveErrorCode::kind_not_possible:
            return "these knots need other counts; Bézier takes degree + 1 points, piecewise Bézier k · degree + 1";
        case CurveErrorCode::curve_not_polynomial_piece:
            return "the curve is not one Bézier piece; it must have degree + 1 equal knots at both ends and no others";
    }
    return "the curve is not valid";
}

}  // namespace batten::core
