#include "app/editor/scene/uniform_cubics.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "app/editor/derived/shown_cubic.h"
#include "app/editor/scene/joint_marks.h"
#include "core/edit/end_vertices.h"
#include "core/evaluate/uniform_cubic_conditions.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_beside = 40;  // joints on each side of the segment at u that are drawn
constexpr double least_median = 12.0;    // design pixels; shorter ones would be blots
constexpr double light_share = 0.45;
constexpr double least_named_triangle = 24.0;  // design pixels; smaller constructions have no names
constexpr int steps_of_segment = 16;

std::optional<ShownCubic> cubic_of(const CanvasFrame& frame) {
    if (cubic_lack(frame.state)) return std::nullopt;
    return shown_cubic(frame.state);
}

/// The joints around the segment at u, as many as are drawn.
std::vector<core::Anticentroid> joints_around(const CanvasFrame& frame, const ShownCubic& cubic) {
    const core::Curve& curve = *frame.curve;
    const std::size_t n = curve.control_points().size();
    const std::size_t first = cubic.segment + 1;
    std::vector<core::Anticentroid> joints;
    if (curve.is_periodic()) {
        const std::size_t count = std::min(n, 2 * most_beside);
        for (std::size_t k = 0; k < count; ++k)
            joints.push_back(core::anticentroid(curve, (first + n - count / 2 + k) % n));
    } else {
        const std::size_t begin = first > most_beside ? first - most_beside : 1;
        for (std::size_t i = begin; i + 1 < n && i <= first + most_beside; ++i)
            joints.push_back(core::anticentroid(curve, i));
    }
    std::erase_if(joints, [](const core::Anticentroid& joint) { return !is_drawable(joint); });
    return joints;
}

render::Color light(const CanvasFrame& frame, render::Color color) {
    return render::blended(color, light_share, frame.theme.canvas);
}

render::Color tangent_color(const CanvasFrame& frame) {
    return frame.theme.accent;
}

render::Color second_color(const CanvasFrame& frame) {
    return frame.theme.level(2);
}

void draw_light_median(CanvasFrame& frame, const core::Anticentroid& joint) {
    const glm::dvec2 vertex = frame.screen(joint.vertex);
    const glm::dvec2 middle = frame.screen(joint.base_middle);
    if (glm::distance(vertex, middle) < frame.pen.px(least_median)) return;
    const render::Color color = light(frame, frame.theme.point(frame.hue(joint.index)));
    frame.pen.segment(vertex, middle, {.color = color, .width = 1.25});
    frame.pen.segment(frame.screen(joint.before), frame.screen(joint.after),
                      {.color = color, .width = 1.0, .dash = 4.0, .gap = 5.0});
}

void draw_triangle_in_focus(CanvasFrame& frame, const core::Anticentroid& joint) {
    const render::Color color = frame.theme.point(frame.hue(joint.index));
    const std::array corners{frame.screen(joint.before), frame.screen(joint.vertex), frame.screen(joint.after)};
    frame.pen.fill({corners.begin(), corners.end()}, render::faded(color, 0.16));
    const glm::dvec2 opposite = frame.screen(joint.vertex + joint.second_derivative);
    const Stroke side{.color = second_color(frame), .width = 1.25, .dash = 3.0, .gap = 4.0};
    frame.pen.segment(corners[0], opposite, side);
    frame.pen.segment(corners[2], opposite, side);
    draw_vector(frame, joint.vertex, joint.second_derivative, second_color(frame), "S″");
    draw_median(frame, joint, color);
    // Half of the base is the tangent, moved there.
    frame.pen.segment(frame.screen(joint.base_middle), corners[2], {.color = tangent_color(frame), .width = 2.0});
}

glm::dvec2 direction(glm::dvec2 vector) {
    const double length = glm::length(vector);
    return length > 0.0 && length < 1e20 ? vector / length : glm::dvec2(0.0);
}

/// S, M and the two thirds of the median, off the tangent and the legs.
void label_median(CanvasFrame& frame, const core::Anticentroid& joint) {
    const glm::dvec2 vertex = frame.screen(joint.vertex);
    const glm::dvec2 middle = frame.screen(joint.base_middle);
    if (glm::distance(vertex, middle) < frame.pen.px(least_named_triangle)) return;
    const glm::dvec2 along = direction(middle - vertex);
    const glm::dvec2 back = direction(frame.screen(joint.before) - frame.screen(joint.after));
    wish_label(frame, joint.anticentroid, "S", frame.theme.text, side_toward(back));
    wish_label(frame, joint.base_middle, "M", frame.theme.dim, side_toward(along + back));
    if (glm::distance(vertex, middle) < frame.pen.px(60.0)) return;
    const double side = along.x * back.y - along.y * back.x < 0.0 ? -1.0 : 1.0;
    const LabelSide beside = side_toward(side * glm::dvec2(-along.y, along.x));
    const auto label = [&](double share, const char* text) {
        frame.labels.push_back({.place = frame.screen(joint.vertex + share * (joint.base_middle - joint.vertex)),
                                .words = {{text, {.color = frame.theme.dim, .size = 13.0}}},
                                .distance = 6.0,
                                .first = beside});
    };
    label(1.0 / 6.0, "1/3");
    label(2.0 / 3.0, "2/3");
}

/// The curve over one segment of these control points.
std::vector<core::Point> segment_line(const std::array<core::Point, 4>& points) {
    std::vector<core::Point> line;
    for (int k = 0; k <= steps_of_segment; ++k) {
        const double t = static_cast<double>(k) / steps_of_segment;
        core::Point place = points[1];
        for (const std::size_t j : {0U, 2U, 3U}) place += core::uniform_cubic_value(j, t) * (points[j] - points[1]);
        line.push_back(place);
    }
    return line;
}

/// What is drawn of an end vertex.
struct EndLook {
    core::EndVertex vertex;
    const char* name;
    std::size_t level;  ///< whose color it has
    LabelSide side;
};

constexpr std::array end_looks{EndLook{core::EndVertex::phantom, "phantom", 2, LabelSide::lower_right},
                               EndLook{core::EndVertex::tripled, "triple", 3, LabelSide::upper_left},
                               EndLook{core::EndVertex::doubled, "double", 1, LabelSide::upper_right}};

/// The outer control points from the end inward, the added ones first.
std::vector<core::Point> outer_points(const core::Curve& curve, core::CurveEnd end, core::EndVertex vertex) {
    const auto P = curve.control_points();
    const std::size_t last = P.size() - 1;
    const auto at = [&](std::size_t k) { return end == core::CurveEnd::start ? P[k] : P[last - k]; };
    std::vector<core::Point> points{at(0), at(1), at(2)};
    if (vertex == core::EndVertex::phantom) points.insert(points.begin(), at(0) + (at(0) - at(1)));
    if (vertex != core::EndVertex::phantom) points.insert(points.begin(), at(0));
    if (vertex == core::EndVertex::tripled) points.insert(points.begin(), at(0));
    return points;
}

/// Whether the leg at the end, the last one of these, is long enough.
bool is_named(const CanvasFrame& frame, const std::vector<core::Point>& points) {
    const std::size_t n = points.size();
    return glm::distance(frame.screen(points[n - 2]), frame.screen(points[n - 3])) >=
           frame.pen.px(least_named_triangle);
}

void draw_phantom(CanvasFrame& frame, const std::vector<core::Point>& points, core::CurveEnd end, render::Color color) {
    if (!core::is_finite(points[0])) return;
    frame.pen.segment(frame.screen(points[0]), frame.screen(points[1]),
                      {.color = color, .width = 1.5, .dash = 5.0, .gap = 5.0});
    frame.pen.symbol(frame.screen(points[0]),
                     {.radius = 6.0, .fill = frame.theme.canvas, .outline = color, .outline_width = 2.0});
    if (!is_named(frame, points)) return;
    const std::size_t last = frame.curve->control_points().size() - 1;
    const std::string text =
        end == core::CurveEnd::start ? "2 P_{0} − P_{1}" : fmt::format("2 P_{{{}}} − P_{{{}}}", last, last - 1);
    wish_label(frame, points[0], text, color);
}

void draw_end(CanvasFrame& frame, core::CurveEnd end) {
    for (const EndLook& look : end_looks) {
        const std::vector<core::Point> points = outer_points(*frame.curve, end, look.vertex);
        const render::Color color = frame.theme.level(look.level);
        if (look.vertex == core::EndVertex::phantom) draw_phantom(frame, points, end, color);
        for (std::size_t k = 0; k + 3 < points.size(); ++k)
            frame.pen.line(frame.screen(segment_line({points[k], points[k + 1], points[k + 2], points[k + 3]})),
                           {.color = color, .width = 2.5, .dash = 7.0, .gap = 4.0});
        const core::Point place = core::end_joint(*frame.curve, end, look.vertex).anticentroid;
        draw_joint(frame, place, color);
        if (is_named(frame, points)) wish_label(frame, place, look.name, color, look.side);
    }
}

/// Joints at vertices that are equal or on one line, with the name of the case, and segments that are straight.
void draw_special_joints(CanvasFrame& frame, const ShownCubic& cubic) {
    for (const core::Anticentroid& joint : joints_around(frame, cubic)) {
        const core::CubicJointCase kind = core::case_of(joint);
        if (kind == core::CubicJointCase::triangle) continue;
        const render::Color color = frame.theme.point(frame.hue(joint.index));
        draw_joint(frame, joint.anticentroid, color);
        wish_label(frame, joint.anticentroid, core::title_of(kind), color, LabelSide::lower_right);
    }
}

void draw_straight_segments(CanvasFrame& frame, const ShownCubic& cubic) {
    const std::size_t begin = cubic.segment > most_beside ? cubic.segment - most_beside : 0;
    const std::size_t end = std::min(cubic.segment_count, cubic.segment + most_beside);
    for (std::size_t k = begin; k < end; ++k) {
        if (!core::is_straight_segment(*frame.curve, k)) continue;
        const core::FergusonSegment segment = core::ferguson_segment(*frame.curve, k);
        frame.pen.segment(frame.screen(segment.start), frame.screen(segment.end),
                          {.color = render::faded(frame.theme.accent, 0.5), .width = 9.0});
    }
}

/// By what whole number the second derivatives are divided, so that none is longer than the vertices are apart.
int shortening_of(const core::CubicMeeting& meeting) {
    core::Box box;
    double longest = 0.0;
    for (const core::Anticentroid& joint : {meeting.first, meeting.second}) {
        for (const core::Point vertex : {joint.before, joint.vertex, joint.after}) box.include(vertex);
        longest = std::max(longest, core::robust_length(joint.second_derivative));
    }
    const double room = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
    for (const int by : {1, 2, 3, 4})
        if (longest <= by * room) return by;
    return 5;
}

void draw_meeting_joint(CanvasFrame& frame, const core::Anticentroid& joint, int shortening, render::Color color) {
    if (!is_drawable(joint)) return;
    for (const core::Point vertex : {joint.before, joint.vertex, joint.after})
        frame.pen.symbol(frame.screen(vertex), {.shape = render::MarkerShape::square,
                                                .radius = 5.0,
                                                .fill = no_color,
                                                .outline = color,
                                                .outline_width = 2.0});
    draw_vector(frame, joint.anticentroid, joint.tangent, color, "C′");
    draw_vector(frame, joint.anticentroid, joint.second_derivative / static_cast<double>(shortening),
                render::blended(color, 0.7, frame.theme.text),
                shortening == 1 ? "C″" : fmt::format("C″/{}", shortening));
    draw_median(frame, joint, color);
    draw_joint(frame, joint.anticentroid, color);
}

}  // namespace

void draw_anticentroid_triangles(CanvasFrame& frame) {
    const std::optional<ShownCubic> cubic = cubic_of(frame);
    if (!cubic) return;
    for (const core::Anticentroid& joint : joints_around(frame, *cubic))
        if (joint.index != cubic->focus.index) draw_light_median(frame, joint);
    if (is_drawable(cubic->focus)) draw_triangle_in_focus(frame, cubic->focus);
}

void draw_anticentroids(CanvasFrame& frame) {
    const std::optional<ShownCubic> cubic = cubic_of(frame);
    if (!cubic) return;
    for (const core::Anticentroid& joint : joints_around(frame, *cubic))
        draw_joint(frame, joint.anticentroid, frame.theme.point(frame.hue(joint.index)));
    const core::Anticentroid& focus = cubic->focus;
    if (!is_drawable(focus)) return;
    draw_vector(frame, focus.anticentroid, focus.tangent, tangent_color(frame), "S′");
    draw_joint(frame, focus.anticentroid, frame.theme.point(frame.hue(focus.index)));
    label_median(frame, focus);
}

void draw_ferguson_form(CanvasFrame& frame) {
    const std::optional<ShownCubic> cubic = cubic_of(frame);
    if (!cubic) return;
    for (const core::Anticentroid& joint : joints_around(frame, *cubic)) {
        draw_vector(frame, joint.anticentroid, joint.tangent, light(frame, tangent_color(frame)), "");
        draw_joint(frame, joint.anticentroid, light(frame, frame.theme.text));
    }
    const bool has_names = glm::distance(frame.screen(cubic->start.anticentroid),
                                         frame.screen(cubic->end.anticentroid)) >= frame.pen.px(least_named_triangle);
    const auto draw = [&](const core::Anticentroid& joint, const char* place, const char* tangent) {
        if (!is_drawable(joint)) return;
        draw_vector(frame, joint.anticentroid, joint.tangent, tangent_color(frame), tangent);
        draw_joint(frame, joint.anticentroid, tangent_color(frame));
        if (!has_names) return;
        wish_label(
            frame, joint.anticentroid, place, frame.theme.text,
            side_toward(frame.screen(joint.anticentroid - joint.second_derivative) - frame.screen(joint.anticentroid)));
    };
    draw(cubic->start, "Q_{0}", "Q_{0}′");
    draw(cubic->end, "Q_{1}", "Q_{1}′");
}

void draw_end_vertices(CanvasFrame& frame) {
    const std::optional<ShownCubic> cubic = cubic_of(frame);
    if (!cubic) return;
    draw_straight_segments(frame, *cubic);
    draw_special_joints(frame, *cubic);
    if (frame.curve->is_periodic()) return;
    // What was added before has its name by then.
    for (const core::CurveEnd end : {core::CurveEnd::start, core::CurveEnd::end})
        if (core::case_of(core::end_joint(*frame.curve, end)) == core::CubicJointCase::triangle) draw_end(frame, end);
}

void draw_joined_cubics(CanvasFrame& frame) {
    const std::optional<JoinedCubic> joined = joined_cubic(frame.state);
    if (!joined) return;
    const bool is_first = joined->end == core::CurveEnd::end;
    const auto& [first, second, continuity, has_equal_steps] = joined->meeting;
    const int shortening = shortening_of(joined->meeting);
    draw_meeting_joint(frame, is_first ? second : first, shortening, frame.theme.level(2));
    draw_meeting_joint(frame, is_first ? first : second, shortening, frame.theme.accent);
}

}  // namespace batten::editor
