#include "app/editor/commands/drawing_commands.h"

#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/edit/joint_keeping.h"
#include "core/make/shapes.h"
#include "core/make/through_points.h"

namespace batten::editor {

namespace {

Outcome<Edit> through_points(const EditorState& state, const ThroughPoints& command) {
    auto fit = core::fit_points_at(command.points, {command.kind, command.parametrization, command.closed});
    auto curve =
        fit ? core::through_points(*fit, state.progress) : core::Result<core::Curve>(core::refuse(fit.error()));
    if (!curve) return refused(state, curve.error());
    Edit edit = with_curve(state, "curve", *std::move(curve));
    edit.document.curves.back().fit = std::make_shared<const core::FitPoints>(*std::move(fit));
    return edit;
}

// The joints that were drawn smooth: both handles are there, and opposite each other.
std::vector<core::KnotMark> smooth_joints(const core::Curve& curve, const BezierPath& path) {
    const std::size_t n = path.points.size();
    const std::vector<core::EditedCurve> curves{{curve}};
    std::vector<core::KnotMark> marks;
    for (std::size_t i = path.closed ? 0 : 3; i + 1 < n; i += 3) {
        const core::Point place = path.points[i];
        if (path.points[(i + n - 1) % n] == place || path.points[i + 1] == place) continue;
        const auto u = static_cast<double>(i / 3);
        if (core::is_kept(curves, {.before = {0, u, core::Side::left}, .after = {0, u, core::Side::right}}))
            marks.push_back({u, core::JointMark::smooth});
    }
    return marks;
}

Outcome<Edit> bezier_path(const EditorState& state, const BezierPath& command) {
    auto curve = core::bezier_path(command.points, command.closed);
    if (!curve) return refused(state, curve.error());
    std::vector<core::KnotMark> marks = smooth_joints(*curve, command);
    Edit edit = with_curve(state, "curve", *std::move(curve));
    edit.document.curves.back().joints.knots = std::move(marks);
    return edit;
}

}  // namespace

const CommandSpec& ThroughPoints::spec() {
    static const CommandSpec spec{
        .name = "through-points",
        .title = "Curve through points",
        .explanation = "Adds a curve through points that can be moved, put in and taken out afterward.",
        .synonyms = "interpolate spline pen fit points",
        .group = CommandGroup::make,
        .submenu = "Through points",
        .fields = {field::positions<&ThroughPoints::points>(
                       "coordinates",
                       "x and y of each point; left out, the selected or all control "
                       "points")
                       .suggesting<suggest::points_of_curve>()
                       .at_least(2.0),
                   field::choice<&ThroughPoints::kind>("kind", "how smooth, and how far a change reaches")
                       .usually(core::FitKind::c2),
                   field::choice<&ThroughPoints::parametrization>("parametrization", "how far apart the parameters are")
                       .usually(core::Parametrization::chordal),
                   field::flag<&ThroughPoints::closed>("closed", "yes for a curve that returns to the first point")
                       .usually(false)},
        .run = body_of<editor::through_points>,
        .at_work = "Passing points",
        .step = "Draw curve through points",
        .done = "Drew {kind} curve through points"};
    return spec;
}

const CommandSpec& BezierPath::spec() {
    static const CommandSpec spec{
        .name = "bezier-path",
        .title = "Bézier path",
        .explanation = "Adds cubic Bézier pieces, one after another: points with two handles between any two.",
        .synonyms = "pen handles piecewise",
        .group = CommandGroup::make,
        .submenu = "Through points",
        .fields =
            {field::positions<&BezierPath::points>("coordinates", "x and y of each point and handle").at_least(3.0),
             field::flag<&BezierPath::closed>("closed",
                                              "yes where the last two are handles back to the first "
                                              "point")
                 .usually(false)},
        .run = body_of<editor::bezier_path>,
        .step = "Draw Bézier path",
        .done = "Drew Bézier path"};
    return spec;
}

void add_drawing_commands(CommandTable& table) {
    add_all<ThroughPoints, BezierPath>(table);
}

}  // namespace batten::editor
