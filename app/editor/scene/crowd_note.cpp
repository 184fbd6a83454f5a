#include "app/editor/scene/crowd_note.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editor/scene/legend.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/length.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double note_side = 14.0;
constexpr double note_bottom = 43.0;   // in the middle of the row of the legend
constexpr double note_step = 20.0;     // from one to the next
constexpr double note_distance = 6.0;  // from the legend
constexpr double note_size = 12.5;
constexpr double most_rounding_px = 1.0;
constexpr double ground_opacity = 0.94;  // over what is drawn there

std::string shown_points_text(const ShownPoints& points) {
    return core::sentence("Showing {shown} of {count} points",
                          {{"shown", points.crowd.shown.size()}, {"count", points.seen}});
}

/// About points alone where there is no room for more.
std::string marks_text(const ShownPoints& points, const ShownKnots& marked, double room) {
    const std::size_t knots = knot_count(marked);
    const bool has_all_points = !points.crowd.is_thinned;
    if (has_all_points && !marked.is_thinned) return "";
    if (!marked.is_thinned) return shown_points_text(points);
    if (has_all_points)
        return core::sentence("Showing {shown} of {count} knots", {{"shown", knots}, {"count", marked.seen}});
    const std::string both = core::sentence(
        "Showing {shown} of {count} points and {knots} of {knot_count} knots",
        {{"shown", points.crowd.shown.size()}, {"count", points.seen}, {"knots", knots}, {"knot_count", marked.seen}});
    return text_size(both, note_size).x <= room ? both : shown_points_text(points);
}

std::string thinned_text(const char* pattern, const Thinned& thinned) {
    if (thinned.shown >= thinned.seen) return "";
    return core::sentence(pattern, {{"shown", thinned.shown}, {"count", thinned.seen}});
}

/// Where curves are drawn no finer than their coordinates are rounded, and that can be seen.
std::string rounding_text(const CanvasFrame& frame) {
    const core::CurveStrips& strips = frame.kept->strips();
    const double rounding = strips.rounding();
    if (!std::isfinite(rounding) || !(rounding * frame.state.view.camera.scale > most_rounding_px)) return "";
    const core::Box& box = strips.box();
    const double farthest = std::max({-box.lower.x, -box.lower.y, box.upper.x, box.upper.y});
    const double step = std::nextafter(farthest, core::Box::infinity) - farthest;
    return core::sentence("Coordinates have steps of {step} here, so that lines are coarse",
                          {{"step", length_words(units_of(frame.state), step)}});
}

/// From below.
std::vector<std::string> note_texts(const CanvasFrame& frame, const CanvasMarks& marks, const ShownPoints& points,
                                    double room) {
    std::vector<std::string> texts{rounding_text(frame), marks_text(points, marks.knots, room),
                                   thinned_text("Showing {shown} of {count} Bézier polygons", marks.pieces),
                                   thinned_text("Showing {shown} of {count} hulls", marks.hulls),
                                   thinned_text("The comb has teeth at {shown} of {count} spans", marks.comb_spans)};
    std::erase(texts, "");
    return texts;
}

bool is_on_left(const CanvasFrame& frame) {
    return shows_legend(frame.state) && frame.state.view.legend_corner == Corner::lower_right;
}

/// About the height `y`.
CrowdNote note_at(const CanvasFrame& frame, std::string text, double y) {
    const glm::dvec2 size = text_size(text, frame.pen.px(note_size));
    const double side = frame.pen.px(note_side);
    const double left = is_on_left(frame) ? side : frame.pen.size_px().x - side - size.x;
    return {std::move(text), {{left, y - 0.5 * size.y}, {left + size.x, y + 0.5 * size.y}}};
}

bool meets_legend(const CanvasFrame& frame, const render::PixelBox& box) {
    if (!shows_legend(frame.state)) return false;
    const glm::dvec2 around(frame.pen.px(note_distance));
    const render::PixelBox legend = legend_box(frame.state, frame.state.view.legend_corner);
    return legend.overlaps({box.lower_px - around, box.upper_px + around});
}

double above_legend(const CanvasFrame& frame) {
    return legend_box(frame.state, frame.state.view.legend_corner).lower_px.y - frame.pen.px(note_step);
}

}  // namespace

std::vector<std::string> thinned_texts(const CanvasFrame& frame, const CanvasMarks& marks, const ShownPoints& points) {
    return note_texts(frame, marks, points, std::numeric_limits<double>::infinity());
}

std::vector<CrowdNote> crowd_notes(const CanvasFrame& frame, const CanvasMarks& marks) {
    std::vector<CrowdNote> notes;
    double y = frame.pen.size_px().y - frame.pen.px(note_bottom);
    for (std::string& text :
         note_texts(frame, marks, marks.points, frame.pen.size_px().x / frame.pen.px(1.0) - 2.0 * note_side)) {
        if (meets_legend(frame, note_at(frame, text, y).box)) y = above_legend(frame);
        notes.push_back(note_at(frame, std::move(text), y));
        y -= frame.pen.px(note_step);
    }
    return notes;
}

void draw_crowd_notes(CanvasFrame& frame, const std::vector<CrowdNote>& notes) {
    const glm::dvec2 around(frame.pen.px(4.0));
    const bool is_left = is_on_left(frame);
    for (const auto& [text, box] : notes) {
        frame.pen.fill(corners_of({box.lower_px - around, box.upper_px + around}),
                       render::faded(frame.theme.canvas, ground_opacity));
        const double y = 0.5 * (box.lower_px.y + box.upper_px.y);
        frame.pen.text({is_left ? box.lower_px.x : box.upper_px.x, y}, text,
                       {.color = frame.theme.dim,
                        .size = note_size,
                        .anchor = is_left ? render::Anchor::left : render::Anchor::right});
    }
}

}  // namespace batten::editor
