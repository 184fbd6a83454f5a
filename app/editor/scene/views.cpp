#include "app/editor/scene/views.h"

#include <array>

#include "app/editor/scene/basis_areas.h"
#include "app/editor/scene/bezier_points_scene.h"
#include "app/editor/scene/construction_views.h"
#include "app/editor/scene/continuity_marks.h"
#include "app/editor/scene/corner_cutting_scene.h"
#include "app/editor/scene/end_marks.h"
#include "app/editor/scene/halves.h"
#include "app/editor/scene/hodograph_inset.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/piece_graphs.h"
#include "app/editor/scene/polygon_distance_scene.h"
#include "app/editor/scene/rational_graphs.h"
#include "app/editor/scene/recurrence_lines.h"

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

constexpr std::array views_below{
    CanvasView{Overlay::by_insertion, draw_inserted_polygon}, CanvasView{Overlay::halves, draw_halves},
    CanvasView{Overlay::corner_cutting, draw_cut_corners}, CanvasView{Overlay::polygon_distance, draw_polygon_rounds},
    CanvasView{Overlay::bezier_points, draw_bezier_points}};
constexpr std::array views_above{CanvasView{Overlay::halves, draw_points_of_halves},
                                 CanvasView{Overlay::blossoms, label_blossoms},
                                 CanvasView{Overlay::triangle, label_construction},
                                 CanvasView{Overlay::corner_cutting, draw_corner_cutting},
                                 CanvasView{Overlay::polygon_distance, draw_polygon_distances},
                                 CanvasView{Overlay::end_derivatives, draw_end_marks},
                                 CanvasView{Overlay::continuity, draw_continuity_marks}};
constexpr std::array<PlotView, 0> plot_views_below{};
constexpr std::array plot_views_above{
    PlotView{Overlay::basis_values, draw_basis_areas}, PlotView{Overlay::rational_basis, draw_rational_graphs},
    PlotView{Overlay::basis_pieces, draw_piece_graphs}, PlotView{Overlay::recurrence, draw_recurrence_lines},
    PlotView{Overlay::corner_cutting, draw_cut_functions}};
constexpr std::array insets{InsetView{Overlay::hodograph, draw_hodograph_inset},
                            InsetView{Overlay::second_hodograph, draw_second_hodograph_inset}};

template <class Frame, class Views>
void draw_shown(Frame& frame, const Views& views) {
    for (const auto& view : views)
        if (frame.state.view.overlays.is_shown(view.overlay)) view.draw(frame);
}

}  // namespace

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
