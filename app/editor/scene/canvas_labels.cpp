#include "app/editor/scene/canvas_labels.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <utility>

#include "app/editor/pointer/weight_ring.h"
#include "app/editor/scene/control_polygon.h"
#include "app/editor/scene/label_layout.h"
#include "app/editor/scene/shown_parameter.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"

namespace batten::editor {

namespace {

constexpr double name_size = 13.0;
constexpr double detail_size = 11.0;
constexpr double point_distance = 11.0;
constexpr double knot_distance = 9.0;
constexpr double boxed_point_distance = 14.0;
constexpr double control_point_reach = 7.5;
constexpr double first_point_reach = 12.0;  // which has a box around it
constexpr double construction_reach = 5.0;
constexpr double mark_reach = 6.0;
constexpr double subscript_reach = 0.25;  // of a line
constexpr double apart_in_figure = 9.0;   // of labels side by side
constexpr double word_gap = 4.0;
constexpr double wished_step = 6.0;
constexpr double farther_in_figure = 18.0;  // than beside its point, where a label may stand
constexpr double ground_error = 0.1;        // of the width of a text that is not measured with its font
constexpr double ground_margin = 2.0;
constexpr double label_ground_opacity = 0.85;
constexpr std::size_t most_unplaced_names = 1000;

bool is_figure(const CanvasFrame& frame) {
    return !frame.state.view.parts.window;
}

/// In pixels; in the window, where more is shown, labels may reach into the box of the first point.
double reach_of_point(const CanvasFrame& frame, std::size_t index) {
    return frame.pen.px(index == 0 && is_figure(frame) ? first_point_reach : control_point_reach);
}

/// Puts labels into free places.
class LabelWriter {
  public:
    LabelWriter(CanvasFrame& frame, const CanvasMarks& marks, const std::vector<render::PixelBox>& covered)
        : frame_(frame), layout_(frame.pen.size_px()), has_grounds_(is_dense(marks.points)) {
        for (const render::PixelBox& box : covered) layout_.avoid_box(box);
        std::vector<const render::CoverageMap*> maps;
        for (const SeenLine& line : {std::cref(frame.curve_line), std::cref(marks.polygon)}) {
            for (const auto& run : line.runs) layout_.avoid_line(run);
            if (line.ink) maps.push_back(line.ink.get());
        }
        layout_.avoid_ink(maps);
        for (const MarkPlace& point : marks.points.large)
            layout_.avoid_symbol(point.place, reach_of_point(frame, point.index));
        if (!is_dense(marks.points)) return;
        for (const MarkPlace& point : marks.points.crowd.shown)
            layout_.avoid_symbol(point.place, frame.pen.px(marks.points.crowd.radius));
    }

    LabelLayout& layout() { return layout_; }

    /// Whether every label lies on a ground, since it is dense everywhere.
    bool has_grounds() const { return has_grounds_; }

    /// Words side by side around `point`, if that is in the picture. Returns false where there is no room for them.
    bool write(glm::dvec2 point, std::vector<LabelWord> words, double distance, LabelSide first, Crowding crowding,
               bool has_ground = false) {
        if (!is_seen(point)) return true;
        const auto place = layout_.place(point, size_px(words), frame_.pen.px(distance), first, crowding);
        return set(place, std::move(words), distance, has_ground);
    }

    /// Begins the next label. In figures it is known by its text in the next frame, and stays on the side and at the
    /// distance where it stood in the frame before as long as `crowding` allows it: what it covers is faint then.
    /// Returns false where it is not written yet.
    bool begin(glm::dvec2 point, const std::vector<LabelWord>& words, Crowding crowding, bool has_ground = false) {
        if (!is_figure(frame_)) return false;
        key_ = frame_.cache.label_spots().next(words.front().text);
        const auto spot = frame_.cache.label_spots().spot(key_);
        if (!spot || !is_seen(point)) return false;
        const auto place_within = [&](Crowding limit) {
            return layout_.place_on(spot->side, point, size_px(words), frame_.pen.px(spot->distance), limit);
        };
        return set(place_within(Crowding::cover_nothing), words, spot->distance, has_ground) ||
               set(place_within(crowding), words, spot->distance, true);
    }

    /// The label that was begun, as write() does, at the first of `distances` where it has room; in figures on a ground
    /// where it covers symbols.
    bool write_at_one_of(std::span<const double> distances, glm::dvec2 point, const std::vector<LabelWord>& words,
                         LabelSide first, Crowding crowding, bool has_ground = false) {
        const bool lies_on_ground = has_ground || (is_figure(frame_) && crowding == Crowding::cover_symbols);
        return std::ranges::any_of(
            distances, [&](double distance) { return write(point, words, distance, first, crowding, lies_on_ground); });
    }

  private:
    bool is_seen(glm::dvec2 point) const { return render::PixelBox{{}, frame_.pen.size_px()}.contains(point); }

    /// Side by side.
    glm::dvec2 size_px(const std::vector<LabelWord>& words) const {
        const double gap = frame_.pen.px(word_gap);
        glm::dvec2 size{-gap, 0.0};
        for (const LabelWord& word : words)
            size = {size.x + gap + width_px(word), std::max(size.y, frame_.pen.px(1.25 * word.style.size))};
        return size;
    }

    bool set(const std::optional<LabelPlace>& place, std::vector<LabelWord> words, double distance, bool has_ground) {
        if (!place) return false;
        if (is_figure(frame_)) frame_.cache.label_spots().put(key_, {place->side, distance});
        if (is_figure(frame_)) spare_surroundings(place->box);
        // Words are set from the end that is anchored, where the true widths of the fonts do no harm.
        const bool is_from_right = place->anchor == render::Anchor::right;
        if (has_grounds_ || has_ground) fill_ground(place->box, is_from_right);
        if (is_from_right) std::reverse(words.begin(), words.end());
        double x = is_from_right ? place->box.upper_px.x : place->box.lower_px.x;
        for (LabelWord& word : words) {
            word.style.anchor = is_from_right ? render::Anchor::right : render::Anchor::left;
            word.style.gap = &word == &words.front() ? 0.0 : word_gap;
            const double width = width_px(word) + frame_.pen.px(word_gap);
            frame_.pen.text({x, place->position.y}, word.text, word.style);
            x += is_from_right ? -width : width;
        }
        return true;
    }

    /// Its subscripts, which reach below the box, where the ground of another label would lie over them, and so much
    /// room beside it that the next label is not read as a part of it.
    void spare_surroundings(const render::PixelBox& box) {
        const glm::dvec2 reach(frame_.pen.px(apart_in_figure), subscript_reach * (box.upper_px.y - box.lower_px.y));
        layout_.avoid_box({box.lower_px - glm::dvec2(reach.x, 0.0), box.upper_px + reach});
    }

    /// Keeps what is dense there from running through the words, which may be longer than they are taken for.
    void fill_ground(const render::PixelBox& box, bool is_from_right) {
        const glm::dvec2 around(frame_.pen.px(ground_margin));
        const double error =
            has_grounds_ ? ground_error : 0.0;  // where little is dense, the ground hides nothing beside it
        const glm::dvec2 longer(error * (box.upper_px.x - box.lower_px.x), 0.0);
        frame_.pen.fill(corners_of({box.lower_px - around - (is_from_right ? longer : glm::dvec2(0.0)),
                                    box.upper_px + around + (is_from_right ? glm::dvec2(0.0) : longer)}),
                        render::faded(frame_.theme.canvas, label_ground_opacity));
    }

    double width_px(const LabelWord& word) const {
        return text_size(word.text, frame_.pen.px(word.style.size), word.style.font).x;
    }

    CanvasFrame& frame_;
    LabelLayout layout_;
    bool has_grounds_;
    LabelSpots::Key key_;  ///< of the label that is being written, in figures
};

/// What is tried for a label, up to what it may do at last; in figures, where labels have not to stay where they are
/// while something moves, first a place where it covers nothing.
std::vector<Crowding> crowdings_until(const CanvasFrame& frame, Crowding last) {
    if (!is_figure(frame)) return {Crowding::leave_out, last};
    return {Crowding::cover_nothing, Crowding::leave_out, last};
}

/// From where a label is beside its point to where it is farther away since it is crowded there, in steps.
std::vector<double> distances_until(double nearest, double farthest) {
    std::vector<double> distances;
    for (double distance = nearest; distance <= std::max(nearest, farthest); distance += wished_step)
        distances.push_back(distance);
    return distances;
}

/// A name, which may have a weight beside it.
struct PointName {
    std::size_t index = 0;
    glm::dvec2 place{};
    std::vector<LabelWord> words;
    double distance = 0.0;  ///< design pixels
};

PointName name_of_point(const CanvasFrame& frame, NumberColumn weights, const MovingPoint& point, double ring_px) {
    const double ring = ring_px / frame.pen.px(1.0);
    PointName name{
        point.index, point.place, {}, std::max(point.index == 0 ? boxed_point_distance : point_distance, ring + 3.0)};
    const auto word = [&](std::string text, render::Color color) {
        return LabelWord{std::move(text), {.color = render::faded(color, point.opacity), .size = name_size}};
    };
    name.words.push_back(word(fmt::format("P_{{{}}}", point.index), frame.theme.text));
    if (point.weight != 1.0)
        name.words.push_back(word(fmt::format("· w {}", weight_text(point.weight, weights)), frame.theme.dim));
    return name;
}

/// Of figures, which nobody can move to make room: with its weight, if need be farther away, else without; over symbols
/// only where these are so dense that single ones do not matter.
void write_name_in_figure(LabelWriter& writer, CanvasFrame& frame, PointName name) {
    const std::vector<double> distances = distances_until(name.distance, name.distance + farther_in_figure);
    const auto write = [&](Crowding crowding, std::size_t count) {
        return writer.write_at_one_of(std::span(distances).first(count), name.place, name.words, LabelSide::upper_right,
                                      crowding);
    };
    if (writer.begin(name.place, name.words, Crowding::leave_out)) return;
    if (write(Crowding::cover_nothing, distances.size()) || write(Crowding::leave_out, 1)) return;
    if (name.words.size() > 1) frame.cache.unplaced().push_back(fmt::format("w_{{{}}}", name.index));
    name.words.resize(1);
    const Crowding last = writer.has_grounds() ? Crowding::cover_symbols : Crowding::leave_out;
    if (write(Crowding::cover_nothing, distances.size()) || write(last, distances.size())) return;
    frame.cache.unplaced().push_back(name.words.front().text);
}

void write_point_name(LabelWriter& writer, CanvasFrame& frame, PointName name) {
    if (is_figure(frame)) return write_name_in_figure(writer, frame, std::move(name));
    const auto* hovered = std::get_if<HoveredPoint>(&frame.state.hover);
    const bool is_hovered = hovered != nullptr && hovered->index == name.index;
    const bool matters = is_hovered || frame.state.selection.contains_point(name.index);
    writer.write(name.place, std::move(name.words), name.distance, LabelSide::upper_right,
                 matters ? Crowding::cover_symbols : Crowding::leave_out);
}

/// Notes the names of a figure's points that are too dense to have one.
void note_nameless(CanvasFrame& frame, const ShownPoints& points) {
    if (!is_figure(frame) || !is_dense(points)) return;
    const std::vector<bool> is_named = is_among(points.large, frame.curve->control_points().size());
    for (std::size_t i = 0; i < is_named.size() && frame.cache.unplaced().size() < most_unplaced_names; ++i)
        if (!is_named[i]) frame.cache.unplaced().push_back(fmt::format("P_{{{}}}", i));
}

void write_point_names(LabelWriter& writer, CanvasFrame& frame, const ShownPoints& points) {
    const NumberColumn weights = frame.state.derived.weights_of(*frame.curve)->column;
    std::vector<glm::dvec2> places;
    for (const MarkPlace& point : points.large)
        places.push_back(frame.screen(frame.curve->control_points()[point.index]));
    writer.layout().tell_apart(std::move(places));
    for (const MarkPlace& point : points.large) {
        const std::size_t i = point.index;
        const glm::dvec2 place = frame.screen(frame.curve->control_points()[i]);
        write_point_name(writer, frame,
                         name_of_point(frame, weights, {place, i, frame.curve->weights()[i]},
                                       weight_ring_radius_px(frame.state, i).value_or(0.0)));
    }
    note_nameless(frame, points);
}

std::string knot_text(const CurveKnot& knot) {
    if (!knot.is_interior) return fmt::format("×{}", knot.multiplicity);
    return fmt::format("×{} {}", knot.multiplicity, continuity_text(knot.continuity));
}

void write_knot(LabelWriter& writer, CanvasFrame& frame, const CurveKnot& knot) {
    if (knot.multiplicity < 2) return;
    const render::Color color = knot.is_lit ? frame.theme.accent : frame.theme.dim;
    const std::vector<LabelWord> words{{knot_text(knot), {.color = color, .size = detail_size}}};
    const std::vector<double> distances =
        distances_until(knot_distance, is_figure(frame) ? knot_distance + farther_in_figure : knot_distance);
    if (writer.begin(knot.places.back(), words, Crowding::leave_out)) return;
    for (const Crowding crowding : crowdings_until(frame, Crowding::cover_symbols))
        if (writer.write_at_one_of(distances, knot.places.back(), words, LabelSide::upper_right, crowding)) return;
    frame.cache.unplaced().push_back(words.front().text);
}

void write_wished(LabelWriter& writer, CanvasFrame& frame, const WishedLabel& label) {
    if (label.words.empty()) return;
    const double farthest = is_figure(frame) ? label.distance + farther_in_figure : label.distance;
    const std::vector<double> distances = distances_until(label.distance, std::max(label.farthest, farthest));
    if (writer.begin(label.place, label.words, label.crowding, label.has_ground)) return;
    for (const Crowding crowding : crowdings_until(frame, label.crowding))
        if (writer.write_at_one_of(distances, label.place, label.words, label.first, crowding, label.has_ground))
            return;
    frame.cache.unplaced().push_back(label.words.front().text);
}

/// The points of the construction, which move with u: only the name of C(u) gives way to them, so that the others stay.
void avoid_construction(LabelWriter& writer, const CanvasFrame& frame) {
    if (!frame.shows(Overlay::construction)) return;
    for (std::size_t r = 1; r + 1 < frame.triangle->levels.size(); ++r)
        for (const core::DeBoorCell& cell : frame.triangle->levels[r])
            writer.layout().avoid_symbol(frame.screen(cell.point), frame.pen.px(construction_reach));
}

/// What views and C(u) are called covers no control point, whatever else it has to cover.
void spare_control_points(LabelWriter& writer, const CanvasFrame& frame, const ShownPoints& points) {
    for (const MarkPlace& point : points.large) {
        const glm::dvec2 reach(reach_of_point(frame, point.index));
        writer.layout().avoid_box({point.place - reach, point.place + reach});
    }
}

/// Beside C(u), or farther away when it is crowded there, before it covers a mark; the dock tells the parameter, too.
void write_curve_point(LabelWriter& writer, CanvasFrame& frame) {
    avoid_construction(writer, frame);
    const glm::dvec2 place = frame.screen(frame.triangle->point());
    const std::string text = fmt::format("C({})", shown_parameter(frame.state.view, *frame.curve, frame.triangle->u));
    const TextStyle style{.color = frame.theme.parameter, .size = name_size, .font = render::LabelFont::bold};
    constexpr std::array distances{13.0, 24.0, 36.0, 52.0, 72.0};
    const std::vector<LabelWord> words{{text, style}};
    if (writer.begin(place, words, Crowding::cover_symbols)) return;
    for (const Crowding crowding : crowdings_until(frame, Crowding::cover_symbols))
        if (writer.write_at_one_of(distances, place, words, LabelSide::lower_right, crowding)) return;
    frame.cache.unplaced().push_back(text);
}

render::PixelBox box_of_label(const render::Label& label) {
    const glm::dvec2 size = text_size(label.text, label.size_px, label.font);
    const double share = label.anchor == render::Anchor::left     ? 0.0
                         : label.anchor == render::Anchor::center ? 0.5
                                                                  : 1.0;
    const glm::dvec2 lower = glm::dvec2(label.position) - glm::dvec2(share * size.x, 0.5 * size.y);
    return {lower, lower + size};
}

}  // namespace

void draw_moving_labels(CanvasFrame& frame, const render::DrawList& list, const CanvasMarks& marks,
                        std::span<const MovingPoint> points) {
    LabelWriter writer(frame, marks, {});
    for (const render::DrawCommand& command : list.commands)
        if (const auto* label = std::get_if<render::Label>(&command)) writer.layout().avoid_box(box_of_label(*label));
    const NumberColumn weights = frame.state.derived.weights_of(*frame.curve)->column;
    std::vector<glm::dvec2> places;
    for (const MovingPoint& point : points) places.push_back(point.place);
    writer.layout().tell_apart(std::move(places));
    for (const MovingPoint& point : points)
        if (point.opacity > 0.0)
            write_name_in_figure(
                writer, frame,
                name_of_point(frame, weights, point,
                              weight_ring_radius_px(point.weight, frame.state.view.interface_scale).value_or(0.0)));
    note_nameless(frame, marks.points);
}

void draw_canvas_labels(CanvasFrame& frame, const CanvasMarks& marks, const std::vector<render::PixelBox>& covered) {
    frame.cache.unplaced().clear();
    const bool has_names = frame.shows(Overlay::labels);
    if (!has_names && frame.labels.empty()) return;
    LabelWriter writer(frame, marks, covered);
    for (const render::PixelBox& box : frame.covered) writer.layout().avoid_box(box);
    for (const auto& line : frame.lines) writer.layout().avoid_faint_line(line);
    for (const glm::dvec2 mark : frame.marks) writer.layout().avoid_symbol(mark, frame.pen.px(mark_reach));
    for (const CurveKnot& knot : marks.knots.knots)
        for (const glm::dvec2 place : knot.places) writer.layout().avoid_symbol(place, frame.pen.px(5.0));
    if (has_names && frame.state.view.parts.names) write_point_names(writer, frame, marks.points);
    spare_control_points(writer, frame, marks.points);
    for (const WishedLabel& label : frame.labels) write_wished(writer, frame, label);
    if (!has_names) return;
    for (const CurveKnot& knot : marks.knots.knots) write_knot(writer, frame, knot);
    if (frame.state.view.parts.parameter) write_curve_point(writer, frame);
}

}  // namespace batten::editor
