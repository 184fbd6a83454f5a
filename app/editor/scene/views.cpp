#include "app/editor/scene/views.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <span>

#include "app/editor/scene/basis_areas.h"
#include "app/editor/scene/bend_marks.h"
#include "app/editor/scene/bezier_points_scene.h"
#include "app/editor/scene/conic_marks.h"
#include "app/editor/scene/construction_views.h"
#include "app/editor/scene/continuity_marks.h"
#include "app/editor/scene/corner_cutting_scene.h"
#include "app/editor/scene/curvature_comb.h"
#include "app/editor/scene/end_marks.h"
#include "app/editor/scene/farin_marks.h"
#include "app/editor/scene/halves.h"
#include "app/editor/scene/hodograph_inset.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/lifted_picture.h"
#include "app/editor/scene/line_crossings.h"
#include "app/editor/scene/other_polygons.h"
#include "app/editor/scene/part_dots.h"
#include "app/editor/scene/piece_graphs.h"
#include "app/editor/scene/polygon_distance_scene.h"
#include "app/editor/scene/quantity_plots.h"
#include "app/editor/scene/rational_graphs.h"
#include "app/editor/scene/recurrence_lines.h"
#include "app/editor/scene/shape_at_parameter.h"
#include "app/editor/scene/support_marks.h"
#include "app/editor/scene/uniform_cubics.h"

namespace batten::editor {

namespace {

struct CanvasView {
    Overlay overlay;
    void (*draw)(CanvasFrame& frame);
};

struct PlotView {
    Overlay overlay;
    void (*draw)(PlotFrame& frame);
};

struct InsetView {
    Overlay overlay;
    void (*draw)(CanvasFrame& frame, const render::PixelBox& box);
};

void draw_comb(CanvasFrame& frame) {
    draw_curvature_comb(frame);
}

constexpr std::array views_below{CanvasView{Overlay::other_polygons, draw_other_polygons},
                                 CanvasView{Overlay::by_insertion, draw_inserted_polygon},
                                 CanvasView{Overlay::halves, draw_halves},
                                 CanvasView{Overlay::corner_cutting, draw_cut_corners},
                                 CanvasView{Overlay::polygon_distance, draw_polygon_rounds},
                                 CanvasView{Overlay::bezier_points, draw_bezier_points},
                                 CanvasView{Overlay::support, draw_support},
                                 CanvasView{Overlay::osculating_circle, draw_osculating_circle},
                                 CanvasView{Overlay::variation, draw_probe_line},
                                 CanvasView{Overlay::anticentroids, draw_anticentroid_triangles},
                                 CanvasView{Overlay::conic, draw_conic_below}};
constexpr std::array views_above{CanvasView{Overlay::halves, draw_points_of_halves},
                                 CanvasView{Overlay::blossoms, label_blossoms},
                                 CanvasView{Overlay::triangle, label_construction},
                                 CanvasView{Overlay::corner_cutting, draw_corner_cutting},
                                 CanvasView{Overlay::polygon_distance, draw_polygon_distances},
                                 CanvasView{Overlay::end_derivatives, draw_end_marks},
                                 CanvasView{Overlay::continuity, draw_continuity_marks},
                                 CanvasView{Overlay::equal_steps, draw_equal_steps},
                                 CanvasView{Overlay::equal_lengths, draw_equal_lengths},
                                 CanvasView{Overlay::curvature_marks, draw_bend_marks},
                                 CanvasView{Overlay::tangent_normal, draw_tangent_and_normal},
                                 CanvasView{Overlay::variation, draw_line_crossings},
                                 CanvasView{Overlay::curvature_comb, draw_comb_handle},
                                 CanvasView{Overlay::anticentroids, draw_anticentroids},
                                 CanvasView{Overlay::ferguson, draw_ferguson_form},
                                 CanvasView{Overlay::end_vertices, draw_end_vertices},
                                 CanvasView{Overlay::joined_cubics, draw_joined_cubics},
                                 CanvasView{Overlay::conic, draw_conic_above},
                                 CanvasView{Overlay::farin_points, draw_farin_points}};
/// Of these a fitted picture shows all.
constexpr std::array framed_views{CanvasView{Overlay::anticentroids, draw_anticentroid_triangles},
                                  CanvasView{Overlay::anticentroids, draw_anticentroids},
                                  CanvasView{Overlay::ferguson, draw_ferguson_form},
                                  CanvasView{Overlay::end_vertices, draw_end_vertices},
                                  CanvasView{Overlay::joined_cubics, draw_joined_cubics},
                                  CanvasView{Overlay::end_derivatives, draw_end_marks},
                                  CanvasView{Overlay::continuity, draw_continuity_marks},
                                  CanvasView{Overlay::curvature_comb, draw_comb}};
constexpr std::array plot_views_below{PlotView{Overlay::support, draw_support_strip}};
constexpr std::array plot_views_above{
    PlotView{Overlay::basis_values, draw_basis_areas},     PlotView{Overlay::rational_basis, draw_rational_graphs},
    PlotView{Overlay::basis_pieces, draw_piece_graphs},    PlotView{Overlay::recurrence, draw_recurrence_lines},
    PlotView{Overlay::corner_cutting, draw_cut_functions}, PlotView{Overlay::curvature_plot, draw_curvature_plot},
    PlotView{Overlay::speed_plot, draw_speed_plot},        PlotView{Overlay::equal_steps, draw_steps_on_axis},
    PlotView{Overlay::equal_lengths, draw_lengths_on_axis}};
constexpr std::array insets{InsetView{Overlay::hodograph, draw_hodograph_inset},
                            InsetView{Overlay::second_hodograph, draw_second_hodograph_inset},
                            InsetView{Overlay::homogeneous, draw_lifted_picture}};

template <class Frame, class Views>
void draw_shown(Frame& frame, const Views& views) {
    for (const auto& view : views)
        if (frame.state.view.overlays.is_shown(view.overlay)) view.draw(frame);
}

/// Takes in what is drawn of lines and symbols.
class Reach {
  public:
    void operator()(const render::Polyline& line) { include(line.points, 0.0F); }
    void operator()(const render::Fill& fill) { include(fill.points, 0.0F); }
    void operator()(const render::Marker& marker) { include({&marker.center, 1}, marker.radius_px); }
    void operator()(const render::Ink&) {}
    void operator()(const render::Region&) {}
    void operator()(const render::ImageQuad&) {}
    void operator()(const render::Label&) {}

    const std::optional<render::PixelBox>& box() const { return box_; }

  private:
    void include(std::span<const render::Pixel> places, float radius_px) {
        for (const render::Pixel place : places) {
            const glm::dvec2 lower(place - radius_px);
            const glm::dvec2 upper(place + radius_px);
            if (!box_) box_ = {lower, upper};
            box_ = {glm::min(box_->lower_px, lower), glm::max(box_->upper_px, upper)};
        }
    }

    std::optional<render::PixelBox> box_;
};

}  // namespace

std::optional<render::PixelBox> reach_of_views(const EditorState& state, SceneCache& cache) {
    const auto is_shown = [&](const CanvasView& view) { return state.view.overlays.is_shown(view.overlay); };
    if (state.visible_active_curve() == nullptr || std::ranges::none_of(framed_views, is_shown)) return std::nullopt;
    render::DrawList list;
    CanvasFrame frame(state, cache, list);
    draw_shown(frame, framed_views);
    Reach reach;
    for (const render::DrawCommand& command : list.commands) std::visit(reach, command);
    return reach.box();
}

void draw_views_below(CanvasFrame& frame) {
    draw_shown(frame, views_below);
}

void draw_views_above(CanvasFrame& frame) {
    draw_shown(frame, views_above);
}

void draw_insets(CanvasFrame& frame) {
    for (const InsetPlace& place : inset_places(frame.state))
        for (const InsetView& view : insets)
            if (view.overlay == place.overlay) view.draw(frame, place.box);
}

void draw_plot_views_below(PlotFrame& frame) {
    draw_shown(frame, plot_views_below);
}

void draw_plot_views_above(PlotFrame& frame) {
    draw_shown(frame, plot_views_above);
}

}  // namespace batten::editor
