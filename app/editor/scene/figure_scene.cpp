#include "app/editor/scene/figure_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <optional>

#include "app/editor/pointer/canvas_cover.h"
#include "app/editor/pointer/fit_view.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/scene/figure_title.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/lifted_picture.h"
#include "app/editor/scene/moving_polygon.h"
#include "app/editor/scene/plot_scene.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double least_plot_height = 160.0;
constexpr double least_canvas_height = 80.0;

constexpr double plot_share = 0.4;   // of the height, below a curve
constexpr double title_share = 0.5;  // of the height, at most

/// The heights of what stands one above the other, in pixels of the figure.
struct FigureHeights {
    std::optional<FigureTitle> set_title;  ///< none where it has no room
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

    void add_title(const FigureHeights& heights, double scale) {
        figure_.lacks_title = !heights.set_title;
        if (heights.title <= 0.0) return;
        render::DrawList list;
        Pen pen(list, {width_px_, heights.title}, scale);
        const std::vector<std::string>& lines = heights.set_title->lines;
        double y = 0.5 * (heights.title - static_cast<double>(lines.size() - 1) * pen.px(heights.set_title->pitch()));
        for (const std::string& line : lines) {
            pen.text({0.5 * width_px_, y}, line,
                     {.color = theme_.text,
                      .size = heights.set_title->size,
                      .anchor = render::Anchor::center,
                      .font = render::LabelFont::bold});
            y += pen.px(heights.set_title->pitch());
        }
        add(std::move(list), heights.title, theme_.canvas);
        figure_.parts.back().is_prose = true;
    }

    void lacks(SceneCache& cache, bool lacks_legend) {
        figure_.unplaced = cache.unplaced();
        figure_.thinned = cache.thinned();
        figure_.lacks_legend = lacks_legend;
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

/// The curve with `moving` in place of its control polygon.
render::DrawList moving_scene(const EditorState& state, MovingPolygon moving, SceneCache& cache) {
    EditorState bare = state;
    bare.view.parts.names = false;
    const core::Curve* curve = state.visible_active_curve();
    if (curve != nullptr) moving.corners = corners_apart(std::move(moving.corners), curve->is_periodic());
    render::DrawList list = canvas_scene_around(moving, bare, cache);
    CanvasFrame frame(state, cache, list);
    if (curve != nullptr) draw_moving_points(frame, list, moving);
    return list;
}

/// Takes the legend away where it would lie over the curves; returns whether it did.
bool leave_out_legend(EditorState& state, const FigureForm& form, SceneCache& cache) {
    const bool is_wanted = has_canvas(form.view) && form.view != FigureView::homogeneous && state.view.parts.legend &&
                           state.view.overlays.is_shown(Overlay::construction) &&
                           state.visible_active_curve() != nullptr;
    if (!is_wanted) return false;
    const render::PixelBox box = legend_box(state, state.view.legend_corner);
    const render::PixelBox page{{}, state.view.camera.size_px};
    const bool has_room = shows_legend(state) && page.contains(box.lower_px) && page.contains(box.upper_px) &&
                          covered(state, state.view.camera, box, cache) == 0;
    state.view.parts.legend = has_room;
    return !has_room;
}

/// The figure of a state whose camera, scale and parts are those of the figure.
render::Figure composed(EditorState state, const FigureForm& form, const FigureHeights& heights,
                        const MovingPolygon& moving, LabelSpots& spots) {
    SceneCache cache;
    spots.begin_frame();
    cache.label_spots() = std::move(spots);
    state.view.parts.fineness = form.fineness;
    const bool lacks_legend = leave_out_legend(state, form, cache);
    const double width = state.view.camera.size_px.x;
    FigurePage page(state, form, width);
    page.add_title(heights, state.view.interface_scale);
    if (form.view == FigureView::homogeneous) {
        page.add(lifted_scene(state, cache), heights.canvas, page.theme().panel);
    } else if (has_canvas(form.view)) {
        page.add(moving.corners.empty() ? canvas_scene(state, CanvasIdle{}, cache) : moving_scene(state, moving, cache),
                 heights.canvas, page.theme().canvas);
    }
    if (has_plot(form.view))
        page.add(plot_scene(state, PlotIdle{}, {width, heights.plot}, cache), heights.plot, page.theme().panel);
    page.lacks(cache, lacks_legend);
    spots = std::move(cache.label_spots());
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

void take_theme(View& view, FigureTheme theme) {
    view.is_presenting = false;
    view.parts.high_contrast = theme == FigureTheme::high_contrast;
    view.theme = theme == FigureTheme::dark ? ThemeName::dark : ThemeName::light;
}

/// What the camera shows, on `size_px`: the same height and width or more.
void take_size(render::Camera& camera, glm::dvec2 size_px) {
    const glm::dvec2 ratio = size_px / camera.size_px;
    camera.scale *= std::min(ratio.x, ratio.y);
    camera.size_px = size_px;
}

/// With the title that a page of that width has, on `page_height_px` or beside it.
FigureHeights heights_with_title(const FigureForm& form, double width_px, double page_height_px) {
    FigureHeights heights;
    const double most = title_share * page_height_px;
    heights.set_title = fitted_title(form.title, width_px / form.scale, most / form.scale);
    // Whole pixels, between which no seam is seen.
    if (heights.set_title)
        heights.title = std::floor(std::min(std::ceil(form.scale * heights.set_title->height()), most));
    return heights;
}

/// Of the basis functions, the knots and the other plots.
double least_height_of_plots(const View& view) {
    return least_plot_height + height_of_plots(view);
}

/// What a page of that height gives to each; nothing gets less than a pixel.
FigureHeights shared_heights(const View& view, const FigureForm& form, glm::dvec2 page_px) {
    FigureHeights heights = heights_with_title(form, page_px.x, page_px.y);
    const double rest = page_px.y - heights.title;
    if (form.view == FigureView::basis) {
        heights.plot = rest;
    } else if (form.view == FigureView::both) {
        const double most = std::max(rest - least_canvas_height * form.scale, 0.5 * rest);
        heights.plot = std::max(plot_share * rest, std::min(least_height_of_plots(view) * form.scale, most));
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
    if (form.theme) take_theme(view, *form.theme);
    const double factor = form.scale / view.interface_scale;
    view.interface_scale = form.scale;
    view.camera.scale *= factor;
    view.camera.size_px = glm::max(glm::round(factor * view.camera.size_px), glm::dvec2(1.0));
    FigureHeights heights = heights_with_title(form, view.camera.size_px.x, view.camera.size_px.y);
    heights.canvas = view.camera.size_px.y;
    heights.plot = std::round(form.scale * view.dock_height);
    if (form.size_px) {
        const glm::dvec2 page = form.scale * *form.size_px;
        heights = shared_heights(view, form, page);
        take_size(view.camera, {page.x, std::max(heights.canvas, 1.0)});
    }
    LabelSpots spots;
    return composed(still, form, heights, {}, spots);
}

glm::dvec2 window_figure_size(const EditorState& state, FigureView view) {
    const glm::dvec2 canvas = state.view.camera.size_px / state.view.interface_scale;
    return {canvas.x, (has_canvas(view) ? canvas.y : 0.0) + (has_plot(view) ? state.view.dock_height : 0.0)};
}

double least_figure_height(const View& view, const FigureForm& form, double width_px) {
    if (!has_plot(form.view)) return 0.0;
    const auto title = fitted_title(form.title, width_px, std::numeric_limits<double>::infinity());
    const double canvas = has_canvas(form.view) ? least_canvas_height : 0.0;
    return std::ceil((title ? title->height() : 0.0) + canvas + least_height_of_plots(view));
}

void pose_for_figure(EditorState& state, const FigureForm& form, glm::dvec2 size_px) {
    bring_to_rest(state);
    const glm::dvec2 page = form.scale * size_px;
    state.view.interface_scale = form.scale;
    state.view.camera.size_px = {page.x, std::max(shared_heights(state.view, form, page).canvas, 1.0)};
    if (has_canvas(form.view)) fit_view(state);
}

render::Figure figure_of(const EditorState& posed, const FigureForm& form, glm::dvec2 size_px,
                         const MovingPolygon& moving, LabelSpots& spots) {
    return composed(posed, form, shared_heights(posed.view, form, form.scale * size_px), moving, spots);
}

render::Figure figure_of(const EditorState& posed, const FigureForm& form, glm::dvec2 size_px) {
    LabelSpots spots;
    return figure_of(posed, form, size_px, {}, spots);
}

}  // namespace batten::editor
