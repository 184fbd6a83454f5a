#include "app/editor/cards/cards.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "app/editor/cards/basis_derivatives_card.h"
#include "app/editor/cards/basis_pieces_card.h"
#include "app/editor/cards/basis_values_card.h"
#include "app/editor/cards/bezier_points_card.h"
#include "app/editor/cards/blossoms_card.h"
#include "app/editor/cards/by_insertion_card.h"
#include "app/editor/cards/continuity_card.h"
#include "app/editor/cards/corner_cutting_card.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/cards/curvature_card.h"
#include "app/editor/cards/end_derivatives_card.h"
#include "app/editor/cards/halves_card.h"
#include "app/editor/cards/invariance_card.h"
#include "app/editor/cards/knot_questions_card.h"
#include "app/editor/cards/parts_card.h"
#include "app/editor/cards/polygon_distance_card.h"
#include "app/editor/cards/quiz_card.h"
#include "app/editor/cards/recurrence_card.h"
#include "app/editor/cards/support_card.h"
#include "app/editor/cards/triangle_card.h"
#include "app/editor/cards/variation_card.h"
#include "app/editor/cards/weight_cards.h"

namespace batten::editor {

namespace {

constexpr std::array sources{CardSource{Overlay::triangle, triangle_card},
                             CardSource{Overlay::halves, halves_card},
                             CardSource{Overlay::by_insertion, by_insertion_card},
                             CardSource{Overlay::blossoms, blossoms_card},
                             CardSource{Overlay::corner_cutting, corner_cutting_card},
                             CardSource{Overlay::polygon_distance, polygon_distance_card},
                             CardSource{Overlay::bezier_points, bezier_points_card},
                             CardSource{Overlay::recurrence, recurrence_card},
                             CardSource{Overlay::basis_pieces, basis_pieces_card},
                             CardSource{Overlay::basis_values, basis_values_card},
                             CardSource{Overlay::rational_basis, rational_basis_card},
                             CardSource{Overlay::basis_derivatives, basis_derivatives_card},
                             CardSource{Overlay::continuity, continuity_card},
                             CardSource{Overlay::osculating_circle, osculating_circle_card},
                             CardSource{Overlay::tangent_normal, tangent_normal_card},
                             CardSource{Overlay::curvature_marks, curvature_marks_card},
                             CardSource{Overlay::equal_steps, equal_steps_card},
                             CardSource{Overlay::equal_lengths, equal_lengths_card},
                             CardSource{Overlay::end_derivatives, end_derivatives_card},
                             CardSource{Overlay::span_hulls, span_hulls_card},
                             CardSource{Overlay::support, support_card},
                             CardSource{Overlay::variation, variation_card},
                             CardSource{Overlay::cubic_conditions, cubic_conditions_card},
                             CardSource{Overlay::cubic_matrix, cubic_matrix_card},
                             CardSource{Overlay::anticentroids, anticentroids_card},
                             CardSource{Overlay::ferguson, ferguson_card},
                             CardSource{Overlay::end_vertices, end_vertices_card},
                             CardSource{Overlay::joined_cubics, joined_cubics_card},
                             CardSource{Overlay::farin_points, farin_card},
                             CardSource{Overlay::conic, conic_card},
                             CardSource{Overlay::homogeneous, homogeneous_card},
                             CardSource{Overlay::invariance, invariance_card},
                             CardSource{Overlay::knot_questions, knot_questions_card},
                             CardSource{Overlay::quiz, quiz_card}};

}  // namespace

namespace {

// The inspector, which has a triangle, is folded away then.
bool is_card_shown(const EditorState& state, Overlay overlay) {
    const Overlays& overlays = state.view.overlays;
    const bool stands_in =
        overlay == Overlay::triangle && state.view.is_presenting && overlays.is_shown(Overlay::construction);
    return overlays.is_shown(overlay) || stands_in;
}

}  // namespace

std::span<const CardSource> card_sources() {
    return sources;
}

std::vector<CardSource> shown_cards(const EditorState& state) {
    std::vector<CardSource> shown;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(shown),
                 [&](const CardSource& source) { return is_card_shown(state, source.overlay); });
    // What was asked for comes before what stands in for a panel.
    std::stable_partition(shown.begin(), shown.end(),
                          [&](const CardSource& source) { return state.view.overlays.is_shown(source.overlay); });
    return shown;
}

}  // namespace batten::editor
