#include "tests/editor/random_session.h"

#include <array>

#include "app/editor/command_reader.h"
#include "app/editor/commands/analysis_commands.h"
#include "app/editor/commands/arranging_commands.h"
#include "app/editor/commands/array_commands.h"
#include "app/editor/commands/axis_commands.h"
#include "app/editor/commands/brush_commands.h"
#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/code_commands.h"
#include "app/editor/commands/combine_commands.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/corner_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fairing_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/fitting_commands.h"
#include "app/editor/commands/form_commands.h"
#include "app/editor/commands/group_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/invariance_commands.h"
#include "app/editor/commands/joint_commands.h"
#include "app/editor/commands/joint_mark_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/knot_question_commands.h"
#include "app/editor/commands/lettering_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/measuring_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/shape_commands.h"
#include "app/editor/commands/shape_view_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/stroke_commands.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/commands/table_commands.h"
#include "app/editor/commands/tear_commands.h"
#include "app/editor/commands/trace_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/commands/trim_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/commands/weight_commands.h"

namespace batten::editor {

double RandomSession::between(double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(below(1024)) / 1024.0;
}

core::Point RandomSession::point(double reach) {
    const double x = between(-reach, reach);
    return {x, between(-reach, reach)};
}

core::Vector RandomSession::vector(double reach) {
    const double x = between(-reach, reach);
    return {x, between(-reach, reach)};
}

// Once in a while one that there is not.
std::size_t RandomSession::index(std::size_t count) {
    return below(20) == 0 ? count + below(3) : below(std::max<std::size_t>(count, 1));
}

double RandomSession::parameter(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    const core::Interval domain = active != nullptr ? active->curve->domain() : core::Interval{0.0, 1.0};
    if (below(20) == 0) return domain.upper + 1.0;
    if (below(10) == 0) return below(2) == 0 ? domain.lower : domain.upper;
    return between(domain.lower, domain.upper);
}

std::vector<std::size_t> RandomSession::indices(std::size_t count) {
    std::vector<std::size_t> result;
    for (std::size_t i = 1 + below(3); i > 0; --i) result.push_back(index(count));
    return result;
}

// The knots stretched, or, once in a while, in a wrong order.
std::vector<double> RandomSession::typed_knots(const core::Curve& curve) {
    const auto stored = curve.knots().stored();
    std::vector<double> knots(stored.begin(), stored.end());
    for (double& knot : knots) knot = 2.0 * knot - 1.0;
    if (below(4) == 0) std::swap(knots.front(), knots.back());
    return knots;
}

// Where nothing suggests itself, a command that is refused in the same way or does no harm.
Command RandomSession::suggested(const EditorState& state, const CommandSpec& spec) {
    Outcome<Command> command = read_command(spec, state);
    return command ? *std::move(command) : Command(Nudge{.offset = {0.0, 0.0}});
}

Command RandomSession::one_of(const EditorState& state,
                              std::initializer_list<std::reference_wrapper<const CommandSpec>> specs) {
    return suggested(state, specs.begin()[below(specs.size())]);
}

Command RandomSession::shape_command(const EditorState& state, const core::Curve& curve) {
    const std::size_t n = curve.control_points().size();
    switch (below(17)) {
        case 14:
            if (below(2) == 0) {
                const core::KnotVector& knots = curve.knots();
                return MarkJoint{.mark = any<core::JointMark>(),
                                 .u = knots.stored()[index(knots.stored().size()) % knots.stored().size()]};
            }
            return PinPoints{.points = {index(n)}};
        case 15:
            if (below(4) == 0) return UnmarkJoint{.u = parameter(state)};
            return UnpinPoints{.points = indices(n)};
        case 16:
            return SoftMove{.center = point(9), .offset = vector(1), .radius = between(-0.2, 9)};
        case 0:
            return MovePoints{.points = indices(n), .offset = vector(2)};
        case 1:
            return SetPoint{.index = index(n), .position = point(9)};
        case 2:
            return SetWeight{.index = index(n), .weight = between(-0.2, 4)};
        case 3:
            return AddPoint{.index = index(n + 1), .position = point(9)};
        case 4:
            return DeletePoints{.points = indices(n)};
        case 5:
            return Nudge{.offset = vector(1)};
        case 6:
            return one_of(state, {NudgeLeft::spec(), NudgeUpFar::spec()});
        case 7:
            return Delete{};
        case 8:
            // Degrees stay small, so that a session of hundreds of commands stays fast.
            return SetDegree{.degree = static_cast<int>(below(6))};
        case 9:
            return curve.degree() < 5 ? Command(Elevate{.by = 1}) : Command(Reduce{.by = 1});
        case 10:
            return Reduce{.by = 1};
        case 11:
            return MoveFarinPoint{.leg = index(n), .share = between(-0.1, 1.1)};
        case 12:
            return MakeCircular{.u = parameter(state)};
        default:
            return ToggleClosed{};
    }
}

Command RandomSession::knot_command(const EditorState& state, const core::Curve& curve) {
    const std::size_t count = curve.knots().stored().size();
    switch (below(10)) {
        case 0:
            return InsertKnot{.u = parameter(state)};
        case 1:
            return suggested(state, InsertKnot::spec());
        case 2:
            return count < 25 ? Command(InsertMidpoints{}) : Command(DeleteKnot{.index = index(count)});
        case 3:
            return RaiseKnot{.index = index(count)};
        case 4: {
            MoveKnot move{.index = index(count), .u = parameter(state), .mode = any<core::KnotMove>()};
            if (move.mode != core::KnotMove::stop) move.snap_distance = between(0, 0.2);
            return move;
        }
        case 5:
            return SetKnot{.index = index(count), .u = parameter(state)};
        case 6:
            return DeleteKnot{.index = index(count)};
        case 7:
            return one_of(state, {AllowTears::spec(), ForbidTears::spec()});
        case 8:
            return SetKind{.kind = any<core::KnotKind>()};
        default:
            return SetKnots{.knots = typed_knots(curve)};
    }
}

Command RandomSession::closing_command(const EditorState& state, const core::Curve& curve) {
    const std::size_t n = curve.control_points().size();
    // Each of these may add points.
    if (n > 25) return DeletePoints{.points = {3}};
    switch (below(10)) {
        case 0:
            return ToPeriodic{.tolerance = between(-0.1, 2)};
        case 1:
            return suggested(state, ToWrapped::spec());
        case 2:
            return ToClamped{};
        case 3:
            return MoveSeam{.u = parameter(state), .tolerance = between(0, 0.1)};
        case 4:
            return below(2) == 0 ? Command(DoubleEnd{.end = any<CurveEnds>()})
                                 : Command(TripleEnd{.end = any<CurveEnds>()});
        case 5:
            return PhantomEnd{.end = any<CurveEnds>()};
        case 6:
            return Straighten{.from = index(n), .to = index(n)};
        case 7:
            return ShareVertices{.other = name(), .end = any<core::CurveEnd>()};
        case 8:
            return CloseOrOpen{};
        default:
            return one_of(state, {FindClosing::spec(), FindCollinearRuns::spec(), FindConicForm::spec(),
                                  FindMatrixForm::spec(), FindAnticentroids::spec(), FindFergusonForm::spec(),
                                  FindBlossomLabels::spec(), FindGrevillePoints::spec()});
    }
}

Command RandomSession::refinement_command(const EditorState& state, const core::Curve& curve) {
    // Inserting and raising in turn would make curves of thousands of points.
    if (curve.control_points().size() > 25 || curve.degree() > 6) return RemoveKnots{.tolerance = between(-0.1, 2)};
    switch (below(10)) {
        case 0:
            return InsertKnots{.knots = {parameter(state), parameter(state)}};
        case 1:
            return RemoveKnot{
                .u = parameter(state), .times = static_cast<int>(below(3)), .tolerance = between(-0.1, 2)};
        case 2:
            return RemoveKnots{.tolerance = between(-0.1, 2)};
        case 3:
            return MergeKnots{.tolerance = between(-0.05, 0.2)};
        case 4:
            return Reparametrize{.begin = between(-2, 1), .end = between(0, 4)};
        case 5:
            return Normalize{};
        case 6:
            return Clamp{.end = any<CurveEnds>()};
        case 7:
            return Unclamp{.end = any<CurveEnds>()};
        default:
            return ToBezier{};
    }
}

Command RandomSession::piece_command(const EditorState& state, const core::Curve& curve) {
    if (below(6) == 0 && curve.control_points().size() < 25)
        return one_of(state, {Unite::spec(), Subtract::spec(), IntersectShapes::spec(), ExcludeShapes::spec(),
                              FindCentroid::spec()});
    if (state.history.present().curves.size() > 6 || curve.control_points().size() > 40 || curve.degree() > 6)
        return SubCurve{.begin = parameter(state), .end = parameter(state)};
    if (below(2) == 0) return joint_command(state);
    switch (below(8)) {
        case 0:
            return Split{.u = parameter(state)};
        case 1:
            return SubCurve{.begin = parameter(state), .end = parameter(state)};
        case 2:
            return curve.control_points().size() < 8 ? Command(BezierPieces{}) : Command(Reverse{});
        case 3:
            return JoinPieces{.tolerance = between(-0.1, 20)};
        case 4:
        case 5:
            return Join{.other = name(), .continuity = any<core::JoinContinuity>()};
        case 6:
            return below(2) == 0 ? Command(Extend{.length = between(-1, 4), .end = any<core::CurveEnd>()})
                                 : Command(ExtendStraight{.length = between(-1, 4), .end = any<core::CurveEnd>()});
        default:
            return ExtendParameter{.by = between(-0.1, 1), .end = any<core::CurveEnd>()};
    }
}

Command RandomSession::joint_command(const EditorState& state) {
    using Continuity = core::GeometricContinuity;
    const auto other = below(2) == 0 ? std::nullopt : std::optional(name());
    switch (below(7)) {
        case 0:
            return Match{.other = name(), .continuity = any<Continuity>(), .end = any<core::CurveEnd>()};
        case 1:
            return Blend{.other = name(),
                         .continuity = any<Continuity>(),
                         .other_continuity = any<Continuity>(),
                         .tension = between(-0.1, 2),
                         .other_tension = 1.0};
        case 2:
            return Fillet{.radius = between(-0.1, 1), .u = parameter(state), .other = other};
        case 3:
            return Chamfer{.distance = between(0, 1), .other_distance = 0.5, .u = parameter(state), .other = other};
        case 4:
            return Trim{.u = parameter(state)};
        case 5:
            return ExtendTo{.other = name(), .end = any<core::CurveEnd>(), .onward = any<core::Onward>()};
        default:
            return below(2) == 0 ? Command(SplitAtCrossings{.scope = any<SplitScope>()})
                                 : Command(CheckJoints{.tolerance = between(-0.1, 2)});
    }
}

Command RandomSession::guide_command() {
    switch (below(5)) {
        case 4:
            return SetUnits{.unit = any<UnitChoice>(), .scale = between(-0.2, 100)};
        case 0:
            return RemoveGuide{.index = below(3)};
        case 1:
            return MoveGuide{.index = below(3), .position = point(9)};
        case 2:
            return below(5) == 0 ? Command(RemoveGuides{}) : Command(SetAngleStep{.degrees = between(-1, 40)});
        default:
            return AddGuide{.position = point(9), .angle = 15.0 * static_cast<double>(below(24))};
    }
}

Command RandomSession::making_command(const EditorState& state) {
    switch (below(6)) {
        case 3:
            return guide_command();
        case 5:
            return TextOutlines{.path = std::filesystem::path(BATTEN_TEST_DATA) / "exchange" / "cubic.otf",
                                .text = below(4) == 0 ? "Ж" : "Lo",
                                .position = point(5),
                                .size = between(-0.2, 3)};
        case 0:
            return AddArc{.center = {between(-5, 5), 0.0},
                          .radius = between(-0.2, 3),
                          .start = 30.0,
                          .sweep = between(-400, 400)};
        case 1:
            return AddConic{.points = {{0, 0}, {between(-2, 2), 1}, {3, between(-1, 1)}}, .weight = between(-0.2, 3)};
        case 2:
            return AddPolygon{.center = {between(-5, 5), 0.0}, .radius = 1.5, .sides = below(9)};
        default:
            return one_of(state, {AddLine::spec(), AddPolyline::spec(), AddPolygon::spec(), AddCircle::spec(),
                                  AddArc::spec(), AddEllipse::spec(), AddEllipticArc::spec(), AddParabola::spec(),
                                  AddHyperbola::spec(), AddConic::spec()});
    }
}

Command RandomSession::fitting_command() {
    std::vector<core::Point> points;
    for (std::size_t i = 3 + below(6); i > 0; --i) points.push_back(point(5));
    if (below(10) == 0) points.insert(points.end(), 2, core::Point(1.0, 1.0));
    const auto degree = static_cast<int>(below(6));
    switch (below(12)) {
        case 9:
            return BezierPath{.points = points, .closed = below(2) == 0};
        case 10:
        case 11:
            return ThroughPoints{.points = points,
                                 .kind = any<core::FitKind>(),
                                 .parametrization = any<core::Parametrization>(),
                                 .closed = below(2) == 0};
        case 0:
            return Interpolate{
                .points = points, .degree = degree, .parametrization = core::Parametrization::centripetal};
        case 1:
            return InterpolateClosed{
                .points = points, .degree = degree, .parametrization = core::Parametrization::uniform};
        case 2:
            return InterpolateNatural{
                .points = points, .degree = 3, .parametrization = core::Parametrization::centripetal};
        case 3:
            return InterpolateTangents{.start = vector(9),
                                       .end = std::nullopt,
                                       .points = points,
                                       .degree = 3,
                                       .parametrization = core::Parametrization::centripetal};
        case 4:
            return FitPoints{.count = below(9), .points = points};
        case 5:
            return FitStroke{.points = points, .smoothness = static_cast<int>(below(11)), .pixel = between(0, 0.5)};
        case 6:
            return RefitStroke{.smoothness = static_cast<int>(below(12))};
        case 7:
            return Redraw{.points = points, .smoothness = 4, .pixel = between(0, 0.5)};
        default:
            return FitPointsWithin{.tolerance = between(-0.2, 2), .points = points, .closed = below(2) == 0};
    }
}

Command RandomSession::fit_point_command(const EditorState& state, const core::FitPoints& fit) {
    const std::size_t count = fit.points.size();
    switch (below(8)) {
        case 0:
            return count < 20 ? Command(InsertFitPoint{.index = index(count + 1), .position = point(9)})
                              : Command(DeleteFitPoint{.index = index(count)});
        case 1:
            return DeleteFitPoint{.index = index(count)};
        case 2:
            return SelectFitPoint{.index = index(count)};
        case 3:
            return SetFitKind{
                .kind = any<core::FitKind>(), .parametrization = any<core::Parametrization>(), .closed = below(2) == 0};
        case 4:
            return below(4) == 0 ? one_of(state, {MakeOrdinary::spec(), Delete::spec()})
                                 : Move{.offset = vector(1), .what = MapTarget::curve};
        case 5:
            return SetFitJoint{.index = index(count),
                               .joint = any<core::FitJoint>(),
                               .handle = below(2) == 0 ? std::nullopt : std::optional(vector(2))};
        default:
            return MoveFitPoint{.index = index(count), .position = point(9)};
    }
}

Command RandomSession::moving_command(const EditorState& state, const core::Curve& curve) {
    if (curve.control_points().size() > 25) return DeletePoints{.points = {3}};
    switch (below(9)) {
        case 0:
            return MoveCurvePoint{.u = parameter(state), .position = point(9)};
        case 1:
            return SetTangent{.u = parameter(state), .derivative = vector(9), .side = any<core::Side>()};
        case 2:
            return MovePointAndTangent{.u = parameter(state), .position = point(9), .derivative = vector(9)};
        case 3:
            return Fair{.distance = between(-0.1, 0.5)};
        case 4:
            if (below(3) == 0) return RefairPart{.distance = between(-0.1, 0.5)};
            return FairPart{.from = parameter(state), .to = parameter(state), .distance = between(-0.1, 0.5)};
        case 5:
            return Rebuild{.count = below(20), .degree = static_cast<int>(below(8))};
        case 6:
            return Simplify{.tolerance = between(-0.1, 0.5)};
        case 7:
            return DeleteAndRefit{.points = {below(30)}};
        default:
            return Offset{.distance = between(-1, 1),
                          .tolerance = 0.05,
                          .side = below(2) == 0 ? std::nullopt : std::optional(any<core::OffsetSide>()),
                          .corners = any<core::OffsetCorners>(),
                          .caps = any<core::OffsetCaps>()};
    }
}

Command RandomSession::transform_command() {
    const auto what = any<MapTarget>();
    const Pivot pivot = below(2) == 0 ? std::nullopt : Pivot(point(9));
    switch (below(16)) {
        case 13:
            return LinkMirror{
                .center = point(9), .angle = below(2) == 0 ? 90.0 : between(0, 180), .is_smooth = below(2) == 0};
        case 14:
            return LinkRotation{.turns = 2 + below(2), .center = point(9)};
        case 15:
            return Unlink{};
        case 8:
            return Align{.at = any<Alignment>(), .what = any<Arranged>()};
        case 9:
            return Distribute{.direction = any<Direction>(), .what = any<Arranged>()};
        case 10:
            return SetLength{.length = between(-1, 20)};
        case 11:
            return SetDistance{.from = below(5), .to = below(5), .distance = between(-1, 9)};
        case 12:
            return below(4) == 0 ? Command(PolarArray{.count = below(4), .center = point(9), .step = between(-90, 90)})
                                 : Command(LinearArray{.count = below(4), .step = vector(3)});
        case 0:
            return Move{.offset = vector(1), .what = what};
        case 1:
            return Rotate{.angle = between(-200, 200), .what = what, .pivot = pivot};
        case 2:
            return Scale{.factor = below(5) == 0 ? 0.0 : between(0.5, 1.5), .what = what, .pivot = pivot};
        case 3:
            return Stretch{.along_x = between(0.5, 1.5), .along_y = between(-1.5, 1.5), .what = what, .pivot = pivot};
        case 4:
            return Shear{.axis = any<ShearAxis>(), .factor = between(-1, 1), .what = what, .pivot = pivot};
        case 5:
            return Mirror{.angle = between(-200, 200), .what = what, .pivot = pivot};
        case 6:
            return MapAffinely{
                .x_row = {1, between(-1, 1), 0}, .y_row = {between(-1, 1), 1, between(-1, 1)}, .what = what};
        default:
            return MapProjectively{.x_row = {1, 0, 0},
                                   .y_row = {0, 1, 0},
                                   .w_row = {between(-0.1, 0.1), between(-0.1, 0.1), 1},
                                   .what = what};
    }
}

Command RandomSession::picture_command(const EditorState& state) {
    const std::filesystem::path folder = std::filesystem::path(BATTEN_TEST_DATA) / "pictures";
    const std::size_t i = index(state.history.present().pictures.size());
    switch (below(9)) {
        case 0:
        case 1:
            return AddPicture{.path = folder / (below(5) == 0 ? "cut_off.png" : "ring_gray.png"),
                              .center = point(5),
                              .width = between(-0.2, 9),
                              .opacity = between(0, 1.1)};
        case 2:
            return RemovePicture{.picture = i};
        case 3:
            return below(2) == 0 ? Command(MovePicture{.picture = i, .position = point(9)})
                                 : Command(PlacePicture{.picture = i,
                                                        .position = point(9),
                                                        .width = between(-0.2, 9),
                                                        .rotation = between(-400, 400)});
        case 4:
            return ScalePicture{.picture = i, .from = point(2), .to = point(2), .length = between(-0.1, 2)};
        case 5:
            return DimPicture{.picture = i, .opacity = between(0, 1.1)};
        case 6:
            return LockPicture{.picture = i, .locked = below(3) == 0};
        case 7:
            return ShowPicture{.picture = i, .visible = below(3) != 0};
        default:
            if (state.history.present().curves.size() > 6) return MeasurePicture{.picture = i};
            return TracePicture{.picture = i,
                                .threshold = below(2) == 0 ? std::nullopt : std::optional(between(-9, 260)),
                                .tolerance = between(-0.05, 1),
                                .speckle = between(0, 2000),
                                .inverted = below(3) == 0};
    }
}

Command RandomSession::table_command() {
    constexpr std::array tables{"x;y\n0,5;1\n2;3\n4;2,5\n5;0\n", "1 2\n3 x\n", "A\t1\t2\nB\t4\t4\nC\t6\t1\nD\t1\t2\n"};
    return PointsFromTable{.text = tables[below(tables.size())],
                           .use = any<TableUse>(),
                           .tolerance = below(2) == 0 ? std::nullopt : std::optional(between(-0.1, 1)),
                           .ends = any<TableEnds>(),
                           .x_column = below(4) == 0 ? std::optional(below(4)) : std::nullopt};
}

Command RandomSession::question_command(const EditorState& state) {
    constexpr std::array vectors{"0 0 0 1 2 3 3 3", "(0, ..., 7), p = 3", "T = (0, 1, 3, 4)", "0 1 0"};
    switch (below(6)) {
        case 0:
            if (state.history.present().curves.size() > 6) return ShowAnswers{.shown = below(2) == 0};
            return SampleCurve{.knots = vectors[below(vectors.size())],
                               .degree = below(2) == 0 ? std::nullopt : std::optional(static_cast<int>(below(4))),
                               .periodic = below(2) == 0};
        case 1:
            return ToggleAnswer{.question = any<KnotQuestion>()};
        case 2:
            return ShowMap{.kind = any<ShownMapKind>(),
                           .amount = below(2) == 0 ? std::nullopt : std::optional(between(-1, 2))};
        case 3:
            return AskQuiz{.number = below(100)};
        case 4:
            return AnswerQuiz{.question = any<KnotQuestion>(), .answer = below(2) == 0 ? "2" : "yes"};
        default:
            return EndQuiz{};
    }
}

Command RandomSession::measuring_command(const EditorState& state) {
    switch (below(6)) {
        case 0:
            return FindPointAtLength{.length = between(-1, 30)};
        case 1:
            return FindNearest{.position = point(9)};
        case 2:
            return IntersectLine{.first = point(9), .second = point(9)};
        case 3:
            return IntersectSegment{.first = point(9), .second = point(9)};
        case 4:
            return MeasureArcLength{.begin = parameter(state), .end = parameter(state)};
        default:
            return one_of(
                state, {FindContinuity::spec(), FindInflections::spec(), FindCurvatureExtrema::spec(),
                        FindCusps::spec(), FindBounds::spec(), FindSpanHulls::spec(), MeasureArcLength::spec(),
                        MeasureArea::spec(), Evaluate::spec(), IntersectCurve::spec(), FindSelfIntersections::spec()});
    }
}

Command RandomSession::document_command(const EditorState& state) {
    const std::size_t count = state.history.present().curves.size();
    if (count > 0 && below(3) == 0) return several_command(state);
    // Not too many curves, or too few.
    if (count > 6) return DeleteCurve{.index = index(count)};
    switch (below(11)) {
        case 0:
            return NewCurve{.points = {{between(-5, 0), 0}, {1, between(0, 5)}, {2, 2}, {3, between(-5, 0)}, {5, 1}}};
        case 1:
            return DeleteCurve{.index = index(count)};
        case 2:
            return DuplicateCurve{.index = index(count), .shift = between(0, 1)};
        case 3:
            return RenameCurve{.index = index(count), .name = name()};
        case 4:
            return SetCurveColor{
                .index = index(count),
                .color = below(2) == 0 ? std::optional(core::DocumentColor{230, 159, 0}) : std::nullopt};
        case 5:
            return SetCurveVisible{.index = index(count), .visible = below(2) == 0};
        case 6:
            return SetCurveLocked{.index = index(count), .locked = below(4) == 0};
        case 7:
            return Cut{};
        case 8:
            return below(2) == 0 ? Command(Copy{}) : CopyAs{.language = any<exchange::CodeLanguage>()};
        case 9:
            return suggested(state, below(2) == 0 ? Paste::spec() : PasteBeside::spec());
        default:
            return suggested(state, Duplicate::spec());
    }
}

std::string RandomSession::parts(const EditorState& state) {
    const std::vector<core::DocumentCurve>& curves = state.history.present().curves;
    std::string text;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (below(2) == 0) continue;
        text += " " + std::to_string(i);
        if (below(2) == 0) continue;
        const std::size_t first = index(curves[i].curve->control_points().size());
        text += ":" + std::to_string(first) + (below(2) == 0 ? "-" + std::to_string(first + 1) : ",0");
    }
    return text;
}

Command RandomSession::several_command(const EditorState& state) {
    const std::size_t count = state.history.present().curves.size();
    switch (below(15)) {
        case 0:
        case 1:
        case 2:
            return SelectParts{.parts = parts(state)};
        case 3:
            return one_of(state, {SelectAllCurves::spec(), InvertSelection::spec()});
        case 4:
            return Move{.offset = vector(2), .what = MapTarget::selection};
        case 5:
            return Rotate{.angle = between(-180, 180), .what = MapTarget::selection};
        case 6:
            return suggested(state, below(2) == 0 ? HideCurves::spec() : ShowCurves::spec());
        case 7:
            return suggested(state, below(3) == 0 ? LockCurves::spec() : UnlockCurves::spec());
        case 8:
            return ColorCurves{.curves = indices(count), .color = core::DocumentColor{1, 2, 3}};
        case 9:
            return below(3) == 0 ? Command(DeleteCurves{.curves = indices(count)}) : Command(Delete{});
        case 10:
            return GroupCurves{.name = name(), .curves = indices(count)};
        case 11:
            return suggested(state, below(3) == 0 ? UngroupCurves::spec() : GroupCurves::spec());
        case 12:
            return RenameGroup{.group = name(), .name = name()};
        case 13:
            return MoveGroup{.group = count > 0 ? state.history.present().curves[below(count)].group : name(),
                             .before = below(2) == 0 ? std::optional(index(count)) : std::nullopt};
        default:
            return MoveCurve{.from = index(count),
                             .to = index(count),
                             .group = below(2) == 0 ? std::optional(name()) : std::nullopt};
    }
}

Command RandomSession::form_command() {
    switch (below(7)) {
        case 0:
            return SetBlossomValues{.by_value = below(2) == 0};
        case 1:
            return SetCombScale{.factor = between(0.1, 20)};
        case 2:
            return SetPartCount{.count = static_cast<int>(1 + below(200))};
        case 3:
            return PutLine{.first = point(9), .second = below(10) == 0 ? core::Point{} : point(9)};
        case 4:
            return LevelLine{};
        case 5:
            return HideViews{};
        default:
            return SetOrbit{.yaw = between(-400, 400), .pitch = between(-90, 90), .zoom = between(0.3, 10)};
    }
}

Command RandomSession::axis_pick_command() {
    if (below(2) == 0)
        return below(2) == 0 ? Command(PickMirror{}) : Command(PickLinkMirror{.is_smooth = below(2) == 0});
    const std::size_t count = 1 + below(5);
    return below(2) == 0 ? Command(PickLinkRotation{.count = count}) : Command(PickArrayPolar{.count = count});
}

Command RandomSession::view_command(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    const std::size_t n = active != nullptr ? active->curve->control_points().size() : 0;
    if (below(4) == 0) return form_command();
    switch (below(9)) {
        case 0:
            return SelectPoints{.points = indices(n)};
        case 1:
            return SelectKnot{.index = index(n)};
        case 2:
            return SelectAll{};
        case 3:
            return below(3) == 0 ? Command(ToggleDrawing{}) : Command(SelectNone{});
        case 4:
            return ActivateCurve{.index = index(state.history.present().curves.size())};
        case 5:
            return below(2) == 0 ? Command(ShowHandlebar{.u = parameter(state)})
                                 : Command(SetParameter{.u = parameter(state)});
        case 6:
            return below(2) == 0   ? Command(TogglePlay{})
                   : below(4) == 0 ? axis_pick_command()
                                   : Command(SetSnap{.kind = SnapKind::grid, .on = below(2) == 0});
        case 7:
            return SetLevel{.level = below(5) == 0 ? std::nullopt : std::optional(static_cast<int>(below(4)))};
        default:
            return suggested(state, Escape::spec());
    }
}

ViewChange RandomSession::view_change(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    const std::size_t n = active != nullptr ? active->curve->control_points().size() : 0;
    switch (below(3)) {
        case 0:
            return Advance{between(0, 20)};
        case 1:
            return ZoomCamera{between(0.5, 2.0), {10.0, 20.0}};
        default:
            return SetHover{HoveredPoint{index(n)}};
    }
}

Command RandomSession::command(const EditorState& state) {
    const core::DocumentCurve* active = state.history.present().active_curve();
    const std::size_t group = below(22);
    if (group < 3) return Undo{};
    if (group < 5) return Redo{};
    if (group < 8) return view_command(state);
    if (active == nullptr || group < 12) {
        if (below(4) != 0 || state.history.present().curves.size() > 6) return document_command(state);
        if (below(4) == 0) return table_command();
        return below(2) == 0 ? making_command(state) : fitting_command();
    }
    if (active->fit != nullptr && below(3) > 0) return fit_point_command(state, *active->fit);
    if (group == 12) return closing_command(state, *active->curve);
    if (group == 14 && below(2) == 0) return measuring_command(state);
    if (group == 13) return moving_command(state, *active->curve);
    if (group == 19 && below(2) == 0) return below(3) == 0 ? question_command(state) : transform_command();
    if (group == 18 && below(2) == 0) return picture_command(state);
    if (group == 20) return refinement_command(state, *active->curve);
    if (group == 21) return piece_command(state, *active->curve);
    return group < 16 ? shape_command(state, *active->curve) : knot_command(state, *active->curve);
}

Request RandomSession::next(const EditorState& state) {
    const std::size_t chance = below(20);
    if (chance == 0) return CancelPreview{};
    if (chance == 1) return view_change(state);
    return CommandRequest{command(state), chance < 7 ? Phase::preview : Phase::commit};
}

}  // namespace batten::editor
