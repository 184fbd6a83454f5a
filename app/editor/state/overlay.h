/// What can be shown beside the curve: lines and marks on the canvas, and the teaching views with their cards.
#pragma once

#include <bitset>
#include <cstddef>

#include "core/base/names.h"

namespace batten::editor {

/// In the order in which they are listed; the first `basic_overlay_count` are no teaching views.
enum class Overlay {
    polygon,
    hull,
    bezier_pieces,
    curvature_comb,
    knots,
    hodograph,
    labels,
    grid,
    construction,
    fill,               ///< what closed curves enclose, by the non-zero rule
    even_odd_fill,      ///< the same by the even-odd rule
    directions,         ///< arrows along the curves
    rulers,             ///< along the upper and the left edge of the canvas, in the document's unit
    triangle,           ///< the triangle of de Boor or de Casteljau with its lines
    halves,             ///< the two curves into which u splits
    by_insertion,       ///< C(u) by inserting u p times
    blossoms,           ///< f(u3,u4,u5) on points
    corner_cutting,     ///< what inserting u does to the polygon
    polygon_distance,   ///< how far the polygon is from the curve
    bezier_points,      ///< names of the Bézier points of the pieces
    recurrence,         ///< the triangle of the basis functions
    basis_pieces,       ///< the polynomials of a basis function
    basis_values,       ///< N_i(u) and their sum
    rational_basis,     ///< R_i,p
    basis_derivatives,  ///< N′
    continuity,         ///< the meter
    curvature_plot,     ///< κ(u) below the basis plot
    speed_plot,         ///< |C′(u)| below the basis plot
    osculating_circle,  ///< at u
    tangent_normal,     ///< at u
    curvature_marks,    ///< inflections and extremes
    equal_steps,        ///< dots at equal steps of u
    equal_lengths,      ///< dots at equal lengths
    second_hodograph,   ///< C″
    end_derivatives,    ///< their formulas
    span_hulls,         ///< the hulls of all spans
    support,            ///< what a point moves
    variation,          ///< a line and its crossings
    other_polygons,     ///< of the curves that are not active
    cubic_conditions,   ///< the fifteen equations
    cubic_matrix,       ///< 1/6 [1 4 1 0; ...]
    anticentroids,      ///< of uniform cubics
    ferguson,           ///< ends and end tangents of each segment
    end_vertices,       ///< double, triple, phantom, collinear
    joined_cubics,      ///< where two of them join
    farin_points,       ///< ratios of weights on the legs
    conic,              ///< of three points
    homogeneous,        ///< the lifted curve in space
    invariance,         ///< map and evaluate
    knot_questions,     ///< the lecture's five
    quiz                ///< makes vectors and marks answers
};
inline constexpr std::size_t overlay_count = 51;
inline constexpr std::size_t basic_overlay_count = 13;

/// Which overlays are chosen, and whether the drawing mode hides those that are in the way of a hand that draws.
class Overlays {
  public:
    bool is_shown(Overlay overlay) const { return is_chosen(overlay) && !hides(overlay); }

    /// Whether it is shown once nothing hides it: what files and settings keep.
    bool is_chosen(Overlay overlay) const { return bits_.test(static_cast<std::size_t>(overlay)); }
    void show(Overlay overlay, bool shown) { bits_.set(static_cast<std::size_t>(overlay), shown); }

    bool is_drawing() const { return is_drawing_; }
    void set_drawing(bool is_drawing) { is_drawing_ = is_drawing; }

    /// Whether the drawing mode hides `overlay` now.
    bool hides(Overlay overlay) const {
        const bool is_in_the_way = overlay == Overlay::hull || overlay == Overlay::knots ||
                                   overlay == Overlay::labels || overlay == Overlay::construction;
        return is_drawing_ && is_in_the_way;
    }
    bool operator==(const Overlays&) const = default;

  private:
    std::bitset<overlay_count> bits_{0b111010011};  // polygon, hull, knots, labels, grid and construction
    bool is_drawing_ = false;
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::Overlay> {
    using enum editor::Overlay;
    static constexpr std::array table{Named{polygon, "polygon", "polygon"},
                                      Named{hull, "hull", "hull"},
                                      Named{bezier_pieces, "bezier-pieces", "Bézier pieces"},
                                      Named{curvature_comb, "curvature-comb", "curvature comb"},
                                      Named{knots, "knots", "knots"},
                                      Named{hodograph, "hodograph", "hodograph"},
                                      Named{labels, "labels", "labels"},
                                      Named{grid, "grid", "grid"},
                                      Named{construction, "construction", "construction"},
                                      Named{fill, "fill", "fill"},
                                      Named{even_odd_fill, "even-odd-fill", "even-odd fill"},
                                      Named{directions, "directions", "directions"},
                                      Named{rulers, "rulers", "rulers"},
                                      Named{triangle, "triangle", "triangle"},
                                      Named{halves, "halves", "two halves"},
                                      Named{by_insertion, "by-insertion", "by insertion"},
                                      Named{blossoms, "blossoms", "blossoms"},
                                      Named{corner_cutting, "corner-cutting", "corner cutting"},
                                      Named{polygon_distance, "polygon-distance", "polygon and curve"},
                                      Named{bezier_points, "bezier-points", "Bézier points"},
                                      Named{recurrence, "recurrence", "recurrence"},
                                      Named{basis_pieces, "basis-pieces", "polynomials"},
                                      Named{basis_values, "basis-values", "values and sum"},
                                      Named{rational_basis, "rational-basis", "rational basis"},
                                      Named{basis_derivatives, "basis-derivatives", "derivatives of the basis"},
                                      Named{continuity, "continuity", "continuity"},
                                      Named{curvature_plot, "curvature-plot", "curvature plot"},
                                      Named{speed_plot, "speed-plot", "speed plot"},
                                      Named{osculating_circle, "osculating-circle", "osculating circle"},
                                      Named{tangent_normal, "tangent-normal", "tangent and normal"},
                                      Named{curvature_marks, "curvature-marks", "inflections and extremes"},
                                      Named{equal_steps, "equal-steps", "equal steps"},
                                      Named{equal_lengths, "equal-lengths", "equal lengths"},
                                      Named{second_hodograph, "second-hodograph", "second hodograph"},
                                      Named{end_derivatives, "end-derivatives", "end derivatives"},
                                      Named{span_hulls, "span-hulls", "hulls of all spans"},
                                      Named{support, "support", "support"},
                                      Named{variation, "variation", "variation diminishing"},
                                      Named{other_polygons, "other-polygons", "other polygons"},
                                      Named{cubic_conditions, "cubic-conditions", "fifteen conditions"},
                                      Named{cubic_matrix, "cubic-matrix", "matrix"},
                                      Named{anticentroids, "anticentroids", "anticentroids"},
                                      Named{ferguson, "ferguson", "Ferguson form"},
                                      Named{end_vertices, "end-vertices", "end vertices"},
                                      Named{joined_cubics, "joined-cubics", "joined cubics"},
                                      Named{farin_points, "farin-points", "Farin points"},
                                      Named{conic, "conic", "conic"},
                                      Named{homogeneous, "homogeneous", "homogeneous view"},
                                      Named{invariance, "invariance", "invariance"},
                                      Named{knot_questions, "knot-questions", "knot questions"},
                                      Named{quiz, "quiz", "quiz"}};
};

}  // namespace batten::core
