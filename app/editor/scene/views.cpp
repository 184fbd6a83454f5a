#include "app/editor/scene/views.h"

#include <array>

#include "app/editor/scene/hodograph_inset.h"
#include "app/editor/scene/insets.h"

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

constexpr std::array<CanvasView, 0> views_below{};
constexpr std::array<CanvasView, 0> views_above{};
constexpr std::array<PlotView, 0> plot_views_below{};
constexpr std::array<PlotView, 0> plot_views_above{};
constexpr std::array insets{InsetView{Overlay::hodograph, draw_hodograph_inset}};

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
