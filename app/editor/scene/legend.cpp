#include "app/editor/scene/legend.h"

#include <algorithm>
#include <string>

#include "app/editor/pointer/canvas_cover.h"
#include "app/editor/pointer/handlebar.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/panel_box.h"
#include "app/editor/scene/text_size.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double legend_side_margin = 14.0;
constexpr double number_room = 14.0;  // below it, for the numbers of the grid
constexpr double legend_height = 30.0;
constexpr double legend_padding = 13.0;
constexpr double text = 12.5;
constexpr double disc_space = 22.0;  // from the end of a text to the next disc
constexpr double disc_to_text = 10.0;
constexpr double least_picture_height = 160.0;  // in a lower one the curve needs all the room
constexpr double inset_distance = 16.0;         // below the insets
constexpr int inset_cost = 1000;                // of covering it, which nothing makes good
constexpr int handle_cost = 100;                // more than curves, which need not be reached
constexpr double legend_reach = 12.0;           // around the legend
constexpr double radius_of_grips = 6.0;
constexpr int reluctance = 2;  // how much less another corner must cover

/// With words, or with numbers only where the canvas is narrow.
enum class Length { full, brief };

/// What stands beside the disc of the color of level r: colors repeat after three levels.
std::string entry_text(std::size_t r, std::size_t degree, std::size_t color_count, Length length) {
    const bool is_brief = length == Length::brief;
    const std::size_t second = r + color_count;
    if (second > degree) return core::sentence(is_brief ? "{level}" : "level {level}", {{"level", r}});
    const char* pattern = second + color_count <= degree ? is_brief ? "{level}, …" : "levels {level}, {next}, …"
                          : is_brief                     ? "{level}, {next}"
                                                         : "levels {level}, {next}";
    return core::filled_as_needed(pattern, {{"level", r}, {"next", second}});
}

double width_of(const std::string& label) {
    return text_size(label, text).x;
}

/// What the legend says.
struct LegendTexts {
    std::string title;
    std::vector<std::string> entries;

    /// In design pixels.
    double width() const {
        double sum = 2.0 * legend_padding + width_of(title) - (title.empty() ? disc_space : 0.0);
        for (const std::string& entry : entries) sum += disc_space + disc_to_text + width_of(entry);
        return sum;
    }
};

LegendTexts texts_of(const EditorState& state, Length length) {
    const core::Curve& curve = *state.visible_active_curve();
    const auto degree = static_cast<std::size_t>(curve.degree());
    const char* title = state.derived.of(curve.knots())->is_bezier ? "de Casteljau" : "de Boor";
    const std::size_t color_count = shown_theme(state.view).levels.size();
    LegendTexts texts{title, {}};
    for (std::size_t r = 1; r <= std::min(degree, color_count); ++r)
        texts.entries.push_back(entry_text(r, degree, color_count, length));
    return texts;
}

/// Without words, then without its title, where the canvas is narrow.
LegendTexts fitting_texts(const EditorState& state) {
    const double room = state.view.camera.size_px.x / state.view.interface_scale - 2.0 * legend_side_margin;
    LegendTexts texts = texts_of(state, Length::full);
    if (texts.width() > room) texts = texts_of(state, Length::brief);
    if (texts.width() > room) texts.title.clear();
    return texts;
}

/// Where what can be dragged beside the curve and its points is in the picture.
std::vector<glm::dvec2> handle_places(const EditorState& state) {
    std::vector<glm::dvec2> places;
    if (const auto bar = shown_handlebar(state))
        for (const HandlebarPart part : {HandlebarPart::middle, HandlebarPart::ahead, HandlebarPart::behind})
            if (const auto place = place_of(*bar, part))
                places.push_back(render::screen_from_world(state.view.camera, *place));
    const auto box = state.tool == Tool::transform ? transform_box(state) : std::nullopt;
    if (!box) return places;
    for (const TransformGrip grip : visible_grips(*box)) places.push_back(grip_place(state, *box, grip));
    return places;
}

int handle_cost_of(const std::vector<glm::dvec2>& handles, const render::PixelBox& box, double reach_px) {
    const render::PixelBox around{box.lower_px - reach_px, box.upper_px + reach_px};
    return handle_cost * static_cast<int>(std::ranges::count_if(
                             handles, [&](const glm::dvec2& place) { return around.contains(place); }));
}

}  // namespace

bool has_legend(const EditorState& state) {
    const bool is_low = state.view.camera.size_px.y < least_picture_height * state.view.interface_scale;
    return !is_low && state.view.parts.legend && state.visible_active_curve() != nullptr &&
           state.view.overlays.is_shown(Overlay::construction);
}

bool shows_legend(const EditorState& state) {
    if (!has_legend(state)) return false;
    const render::PixelBox box = legend_box(state, state.view.legend_corner);
    return handle_cost_of(handle_places(state), box, radius_of_grips * state.view.interface_scale) == 0;
}

render::PixelBox legend_box(const EditorState& state, Corner corner) {
    const double scale = state.view.interface_scale;
    const glm::dvec2 picture = state.view.camera.size_px / scale;
    const glm::dvec2 size{fitting_texts(state).width(), legend_height};
    const bool is_left = corner == Corner::lower_left || corner == Corner::upper_left;
    const bool is_lower = corner == Corner::lower_left || corner == Corner::lower_right;
    const Overlays& overlays = state.view.overlays;
    const bool has_numbers =
        state.view.parts.window || overlays.is_shown(Overlay::grid) || overlays.is_shown(Overlay::rulers);
    const double bottom = legend_side_margin + (has_numbers ? number_room : 0.0);
    const std::optional<render::PixelBox> insets = insets_box(state);
    const double top =
        corner == Corner::upper_right && insets ? insets->upper_px.y / scale + inset_distance : legend_side_margin;
    const glm::dvec2 lower{is_left ? legend_side_margin : picture.x - legend_side_margin - size.x,
                           is_lower ? picture.y - bottom - size.y : top};
    return {scale * lower, scale * (lower + size)};
}

bool meets_inset(const EditorState& state, Corner corner) {
    const std::optional<render::PixelBox> insets = insets_box(state);
    return insets && legend_box(state, corner).overlaps(*insets);
}

Corner free_corner(const EditorState& state, SceneCache& cache) {
    if (!has_legend(state)) return state.view.legend_corner;
    const std::vector<glm::dvec2> handles = handle_places(state);
    const auto cost = [&](Corner corner) {
        const render::PixelBox box = legend_box(state, corner);
        return covered(state, state.view.camera, box, cache) + (meets_inset(state, corner) ? inset_cost : 0) +
               handle_cost_of(handles, box, legend_reach * state.view.interface_scale);
    };
    Corner best = state.view.legend_corner;
    int least = cost(best);
    if (least == 0) return best;
    // Only for a clearly better place, so that it does not go to and fro while something is dragged along.
    least = std::max(1, least - reluctance + 1);
    for (const Corner corner : all_corners) {
        const int sum = cost(corner);
        if (sum >= least) continue;
        least = sum;
        best = corner;
    }
    return best;
}

void draw_legend(CanvasFrame& frame) {
    const render::PixelBox box = legend_box(frame.state, frame.state.view.legend_corner);
    Pen& pen = frame.pen;
    draw_panel_box(pen, frame.theme, box);
    const LegendTexts texts = fitting_texts(frame.state);
    const double y = 0.5 * (box.lower_px.y + box.upper_px.y);
    double x = box.lower_px.x + pen.px(legend_padding);
    if (!texts.title.empty()) {
        pen.text({x, y}, texts.title, {.color = frame.theme.dim, .size = text});
        x += pen.px(width_of(texts.title) + disc_space);
    }
    for (std::size_t r = 1; r <= texts.entries.size(); ++r) {
        const std::string& entry = texts.entries[r - 1];
        pen.symbol({x, y}, {.radius = 5.0, .fill = frame.theme.level(r), .outline = no_color});
        x += pen.px(disc_to_text);
        pen.text({x, y}, entry, {.color = frame.theme.text, .size = text});
        x += pen.px(width_of(entry) + disc_space);
    }
}

}  // namespace batten::editor
