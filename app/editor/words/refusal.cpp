#include "app/editor/words/refusal.h"

#include "app/editor/state/state.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

/// Which numbers of an error are lengths.
struct LengthsOfError {
    bool value = false;
    bool lower = false;
    bool upper = false;
};

// A line for each code, so that a new one is decided on.
LengthsOfError lengths_of(core::CurveErrorCode code) {  // NOLINT(readability-function-size)
    using enum core::CurveErrorCode;
    switch (code) {
        case length_not_positive:
        case tolerance_not_positive:
        case shape_vanishes:
            return {.value = true};
        case ends_apart:
        case deviation_too_large:
        case extension_too_far:
        case legs_unequal:
        case fillet_too_large:
        case chamfer_too_long:
            return {.value = true, .upper = true};
        case tolerance_not_reached:
            return {.value = true, .lower = true};
        case offset_too_far:
            return {.lower = true, .upper = true};
        case fillet_not_possible:
            return {.value = true, .lower = true, .upper = true};
        case degree_out_of_range:
        case too_few_points:
        case knot_count_mismatch:
        case weight_count_mismatch:
        case knot_not_finite:
        case point_not_finite:
        case weight_not_finite:
        case weight_not_positive:
        case knot_decreasing:
        case multiplicity_too_high:
        case knots_too_far_apart:
        case domain_empty:
        case parameter_not_finite:
        case parameter_outside_domain:
        case multiplicity_full:
        case knot_index_out_of_range:
        case point_index_out_of_range:
        case knot_not_removable:
        case kind_not_possible:
        case range_empty:
        case angle_out_of_range:
        case points_coincide:
        case points_collinear:
        case degree_unsuitable:
        case curve_not_closed:
        case curve_not_uniform_cubic:
        case curve_rational:
        case data_points_too_few:
        case data_point_not_finite:
        case parameter_count_mismatch:
        case parameters_not_increasing:
        case degree_too_low:
        case vector_not_finite:
        case equations_singular:
        case control_points_too_many:
        case smoothing_negative:
        case points_pinned:
        case tangent_not_free:
        case curve_stands_still:
        case curve_has_corner:
        case leg_vanishes:
        case knot_not_found:
        case knots_coincide:
        case curve_periodic:
        case parameter_at_end:
        case curve_not_polynomial_piece:
        case curve_closed:
        case outer_knots_too_far:
        case joint_turns_back:
        case share_out_of_range:
        case piece_not_bezier:
        case map_not_finite:
        case map_singular:
        case point_beyond_horizon:
        case fit_point_index_out_of_range:
        case tension_not_positive:
        case ends_meet:
        case end_stands_still:
        case no_fillet:
        case no_corner:
        case nothing_crosses:
        case other_not_reached:
        case shapes_not_decided:
        case stroke_too_short:
        case not_computable:
            break;
    }
    return {};
}

}  // namespace

std::string refusal_words(const Units& units, const core::CurveError& error) {
    const LengthsOfError lengths = lengths_of(error.code);
    if (!units || !(lengths.value || lengths.lower || lengths.upper)) return core::describe(error);
    const auto words = [&](double number, bool is_length) {
        return is_length ? length_words(units, number) : core::shortest_text(number);
    };
    return core::filled_as_needed(core::sentence_template(error), {{"value", words(error.value, lengths.value)},
                                                                   {"lower", words(error.lower, lengths.lower)},
                                                                   {"upper", words(error.upper, lengths.upper)}});
}

tl::unexpected<std::string> refused(const EditorState& state, const core::CurveError& error) {
    return refused(units_of(state), error);
}

tl::unexpected<std::string> refused(const Units& units, const core::CurveError& error) {
    return tl::unexpected(refusal_words(units, error));
}

}  // namespace batten::editor
