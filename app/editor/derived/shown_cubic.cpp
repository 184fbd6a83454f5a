#include "app/editor/derived/shown_cubic.h"

namespace batten::editor {

namespace {

std::optional<CubicLack> lack_of(const EditorState& state, const core::Curve& curve) {
    if (curve.degree() != 3) return CubicLack::degree;
    const core::KnotKind kind = state.derived.of(curve.knots())->kind;
    if (kind != core::KnotKind::uniform && kind != core::KnotKind::periodic) return CubicLack::knots;
    if (curve.is_rational()) return CubicLack::weights;
    return std::nullopt;
}

bool is_open_cubic(const EditorState& state, const core::DocumentCurve& item) {
    return item.visible && !item.curve->is_periodic() && !lack_of(state, *item.curve);
}

double gap_of(const core::CubicMeeting& meeting) {
    return core::distance(meeting.first.anticentroid, meeting.second.anticentroid);
}

std::optional<std::size_t> hovered_point(const Hover& hover) {
    if (const auto* point = std::get_if<HoveredPoint>(&hover)) return point->index;
    if (const auto* basis = std::get_if<HoveredBasis>(&hover)) return basis->index;
    return std::nullopt;
}

std::size_t focused_point(const EditorState& state, const core::Curve& curve, const ShownCubic& cubic) {
    const auto hovered = hovered_point(state.hover);
    if (hovered && has_joint(curve, *hovered)) return *hovered;
    const std::vector<std::size_t>& selected = state.selection.points;
    if (selected.size() == 1 && has_joint(curve, selected.front())) return selected.front();
    return cubic.points[cubic.t < 0.5 ? 1 : 2];
}

}  // namespace

std::optional<CubicLack> cubic_lack(const EditorState& state) {
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return CubicLack::curve;
    return lack_of(state, *curve);
}

bool has_joint(const core::Curve& curve, std::size_t i) {
    const std::size_t n = curve.control_points().size();
    return i < n && (curve.is_periodic() || (0 < i && i + 1 < n));
}

ShownCubic shown_cubic(const EditorState& state) {
    const core::Curve& curve = *state.visible_active_curve();
    const double u = state.parameter();
    ShownCubic cubic{.segment = core::cubic_segment_index(curve, u), .segment_count = core::cubic_segment_count(curve)};
    const core::Interval interval{curve.knots()[cubic.segment + 3], curve.knots()[cubic.segment + 4]};
    cubic.t = (interval.clamp(u) - interval.lower) / interval.length();
    for (std::size_t j = 0; j < 4; ++j) cubic.points[j] = (cubic.segment + j) % curve.control_points().size();
    cubic.start = core::anticentroid(curve, cubic.points[1]);
    cubic.end = core::anticentroid(curve, cubic.points[2]);
    cubic.focus = core::anticentroid(curve, focused_point(state, curve, cubic));
    return cubic;
}

std::optional<JoinedCubic> joined_cubic(const EditorState& state) {
    const core::Document& document = state.shown();
    if (document.curves.size() < 2) return std::nullopt;
    const std::size_t other = (document.active + 1) % document.curves.size();
    const core::DocumentCurve& active = document.curves[document.active];
    if (!is_open_cubic(state, active) || !is_open_cubic(state, document.curves[other])) return std::nullopt;
    const core::Curve& next = *document.curves[other].curve;
    const core::CubicMeeting at_end = core::meeting_of_cubics(*active.curve, next);
    const core::CubicMeeting at_start = core::meeting_of_cubics(next, *active.curve);
    if (gap_of(at_start) < gap_of(at_end)) return JoinedCubic{other, core::CurveEnd::start, at_start};
    return JoinedCubic{other, core::CurveEnd::end, at_end};
}

}  // namespace batten::editor
