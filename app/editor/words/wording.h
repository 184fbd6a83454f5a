/// Sentences about what an edit did.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/words/length.h"
#include "core/curve/curve.h"

namespace batten::editor {

/// How far an edit went, where that is known.
struct Distances {
    std::optional<double> deviation{};  ///< from the curve before, at equal parameters
    std::optional<double> of_shapes{};  ///< the same whatever the parameters, where it is much less
    std::optional<double> error{};      ///< of what approximates something else
    bool is_rounding = false;           ///< the deviation is what rounding of the coordinates makes
    Units units{};                      ///< in which they are told
};

/// What is said after a step: `done` ("Moved P₅") with what it did to the shape, or how far off its result is. Without
/// a curve to compare with there is no deviation, without an approximation no error.
std::string done_sentence(const std::string& done, ShapeEffect effect, const Distances& distances);

/// What is said after an edit that left everything as it was.
std::string nothing_changed_sentence();

/// How far off, as a part of its size, a computed number may be by rounding.
inline constexpr double rounding_error = 1e-14;

/// The largest |x| or |y| in a box; 0 where it is empty.
double largest_coordinate(const core::Box& box);

/// Numbers of one kind, with 0 for those that are nothing but the rounding of the largest, which is finite.
std::vector<double> without_rounding(std::span<const double> values);
core::Vector without_rounding(core::Vector vector);

/// How far off a coordinate of a point on the curve may be by rounding; 0 where its box is not known.
double coordinate_error(const core::Curve& curve);
double coordinate_error(const core::Box& box);

/// The length that `relative` (>= 0) means for the curve: times the larger side of the curve's own box, which far
/// control points of small weight do not widen, and never less than the rounding of its coordinates; 0 where its box is
/// not known.
double shape_tolerance(const core::Curve& curve, double relative);

/// Whether `deviation` is at most that length. Quick where it is much more.
bool is_within_tolerance(const core::Curve& curve, double deviation, double relative);

/// "(1, -0.5)", or "(1, -0.5) mm", with 0 for a coordinate that is not above `error`.
std::string place_words(const Units& units, core::Point place, double error = 0.0);

/// What a length of the world is at most, as bound_text has it: "0.0625 mm".
std::string bound_words(const Units& units, double world, int digits = 4);

/// "(1, -0.5)" with as many decimals as show where it is among things of `size` (number_column.h).
std::string place_text(const Units& units, double size, core::Point place);

/// "'wave'", or "3 curves".
std::string curves_text(const core::Document& document, const std::vector<std::size_t>& curves);

/// What a knot of the value `u` means for the curve: "multiplicity 2, C¹ there".
std::string knot_words(const core::Curve& curve, double u);

/// That u = `asked` is outside of the domain and `taken` stands for it.
std::string clamped_sentence(const core::KnotVector& knots, double asked, double taken);

/// What is said when knot `index` of stored() was deleted, which took a control point along: "Deleted knot 0.5 and P₃".
StepTexts texts_of_deleted_knot(const core::Curve& before, std::size_t index, const core::Curve& after);

}  // namespace batten::editor
