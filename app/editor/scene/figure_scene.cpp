#include "app/editor/scene/figure_scene.h"

#include <algorithm>
#include <glm/common.hpp>

#include "app/editor/pointer/fit_view.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/lifted_picture.h"
#include "app/editor/scene/plot_scene.h"
#include "app/editor/scene/text_size.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double figure_title_height = 44.0;
constexpr double figure_title_size = 18.0;
constexpr double figure_title_margin = 16.0;
constexpr double least_plot_height = 160.0;

constexpr double plot_share = 0.4;  // of the height, below a curve
constexpr double moving_radius = 6.5;

/// The heights of what stands one above the other, in pixels of the figure.
struct FigureHeights {
    double title = 0.0;
    double canvas = 0.0;
    double plot = 0.0;
};

bool has_canvas(FigureView view) {
    return view != FigureView::basis;
}

bool has_plot(FigureView view) {
    return view == FigureView::basis || view == FigureView::both;
}

/// Puts parts below one another on a page.
class FigurePage {
  public:
    FigurePage(const EditorState& state, const FigureForm& form, double width_px)
        : theme_(shown_theme(state.view)), form_(form), width_px_(width_px) {
        figure_.title = form.title;
    }

    void add(render::DrawList list, double height_px, render::Color ground) {
        figure_.parts.push_back({std::move(list),
                                 {{0.0, bottom_px_}, {width_px_, bottom_px_ + height_px}},
                                 form_.is_transparent ? std::nullopt : std::optional(ground)});
        bottom_px_ += height_px;
        figure_.size_px = {width_px_, bottom_px_};
    }

    /// As large as it fits in one line.
    void add_title(double height_px, double scale) {
        if (height_px <= 0.0) return;
        render::DrawList list;
        Pen pen(list, {width_px_, height_px}, scale);
        const double room = std::max(1.0, width_px_ / scale - 2.0 * figure_title_margin);
        const double width = text_size(form_.title, figure_title_size, render::LabelFont::bold).x;
        pen.text({0.5 * width_px_, 0.5 * height_px}, form_.title,
                 {.color = theme_.text,
                  .size = figure_title_size * std::min(1.0, room / width),
                  .anchor = render::Anchor::center,
                  .font = render::LabelFont::bold});
        add(std::move(list), height_px, theme_.canvas);
    }

    const Theme& theme() const { return theme_; }
    render::Figure take() { return std::move(figure_); }

  private:
    Theme theme_;
    const FigureForm& form_;
    double width_px_;
    double bottom_px_ = 0.0;
    render::Figure figure_;
};

render::DrawList lifted_scene(const EditorState& state, SceneCache& cache) {
    render::DrawList list;
    CanvasFrame frame(state, cache, list);
    if (frame.curve != nullptr) draw_lifted_curve(frame, {{}, state.view.camera.size_px});
    return list;
}

void draw_moving_polygon(render::DrawList& list, const EditorState& state, std::span<const CutCorner> moving) {
    SceneCache cache;
    CanvasFrame frame(state, cache, list);
    if (frame.curve == nullptr || moving.empty()) return;
    std::vector<glm::dvec2> places;
    for (const CutCorner& corner : moving) places.push_back(frame.screen(corner.place));
    if (frame.curve->is_periodic()) places.push_back(places.front());
    frame.pen.line(places, {.color = frame.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0});
    for (std::size_t i = 0; i < moving.size(); ++i)
        frame.pen.symbol(places[i], {.radius = moving_radius,
                                     .fill = frame.theme.point(frame.hue(moving[i].index)),
                                     .outline = frame.theme.canvas,
                                     .outline_width = 2.0});
}

/// The figure of a state whose camera, scale and parts are those of the figure.
render::Figure composed(const EditorState& state, const FigureForm& form, const FigureHeights& heights,
                        std::span<const CutCorner> moving) {
    SceneCache cache;
    const double width = state.view.camera.size_px.x;
    FigurePage page(state, form, width);
    page.add_title(heights.title, state.view.interface_scale);
    if (form.view == FigureView::homogeneous) {
        page.add(lifted_scene(state, cache), heights.canvas, page.theme().panel);
    } else if (has_canvas(form.view)) {
        render::DrawList list = canvas_scene(state, CanvasIdle{}, cache);
        draw_moving_polygon(list, state, moving);
        page.add(std::move(list), heights.canvas, page.theme().canvas);
    }
    if (has_plot(form.view))
        page.add(plot_scene(state, PlotIdle{}, {width, heights.plot}, cache), heights.plot, page.theme().panel);
    return page.take();
}

/// Takes away what belongs to a pointer or to an edit under way.
void bring_to_rest(EditorState& state) {
    state.hover = HoveredNothing{};
    state.selection = {};
    state.placing = {};
    state.ghost.reset();
    state.axis_pick.reset();
    state.gauge.reset();
    state.pivot.reset();
    state.at_work.reset();
    state.tool = Tool::select;
    state.view.playback.is_playing = false;
    state.view.parts.window = false;
}

double title_height(const FigureForm& form) {
    return form.title.empty() ? 0.0 : figure_title_height * form.scale;
}

/// What a page of that height gives to each; nothing gets less than a pixel.
FigureHeights shared_heights(const FigureForm& form, double height_px) {
    FigureHeights heights{.title = std::min(title_height(form), 0.5 * height_px)};
    const double rest = height_px - heights.title;
    if (form.view == FigureView::basis) {
        heights.plot = rest;
    } else if (form.view == FigureView::both) {
        const double least = std::min(least_plot_height * form.scale, 0.5 * rest);
        heights.plot = std::max(plot_share * rest, least);
    }
    heights.canvas = rest - heights.plot;
    return heights;
}

}  // namespace

render::Figure window_figure(const EditorState& state, const FigureForm& form) {
    EditorState still = state;
    bring_to_rest(still);
    View& view = still.view;
    view.parts.points = view.overlays.is_shown(Overlay::polygon);
    const double factor = form.scale / view.interface_scale;
    view.interface_scale = form.scale;
    view.camera.scale *= factor;
    view.camera.size_px *= factor;
    const FigureHeights heights{
        .title = title_height(form), .canvas = view.camera.size_px.y, .plot = form.scale * view.dock_height};
    return composed(still, form, heights, {});
}

void pose_for_figure(EditorState& state, const FigureForm& form, glm::dvec2 size_px) {
    bring_to_rest(state);
    const glm::dvec2 page = form.scale * size_px;
    state.view.interface_scale = form.scale;
    state.view.camera.size_px = {page.x, std::max(shared_heights(form, page.y).canvas, 1.0)};
    if (has_canvas(form.view)) fit_view(state);
}

render::Figure figure_of(const EditorState& posed, const FigureForm& form, glm::dvec2 size_px,
                         std::span<const CutCorner> moving) {
    return composed(posed, form, shared_heights(form, form.scale * size_px.y), moving);
}

}  // namespace batten::editor
