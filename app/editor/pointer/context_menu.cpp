#include "app/editor/pointer/context_menu.h"

#include <fmt/core.h>

#include "app/editor/commands/brush_commands.h"
#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/code_commands.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fairing_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/group_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/joint_commands.h"
#include "app/editor/commands/joint_mark_commands.h"
#include "app/editor/commands/joint_tool_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/pen_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/state/selected_parts.h"
#include "app/editor/upkeep.h"

namespace batten::editor {

namespace {

using enum core::FitJoint;

// Collects the entries of a menu.
class Menu {
  public:
    explicit Menu(const EditorState& state) : state_(state) {}

    std::vector<MenuEntry> take() { return std::move(entries_); }

    void points() {
        offer<SetPoint, SetWeight, MovePoints, PinPoints, UnpinPoints>();
        group();
        offer<Delete, DeleteAndRefit>();
        group();
        offer<SelectAll, SelectNone>();
    }

    void fit_point() {
        offer<JoinAt<smooth>, JoinAt<tangent>, JoinAt<corner>, JoinAt<straight>, JoinAt<corner_straight>>();
        group();
        offer<MoveFitPoint, Delete>();
        group();
        offer<SetFitKind, MakeOrdinary>();
    }

    void pens() {
        using enum PenMode;
        offer<UsePen<control_points>, UsePen<through_c2>, UsePen<through_local>, UsePen<through_fair>,
              UsePen<bezier>>();
        group();
    }

    void knot(std::size_t index) {
        add(RaiseKnot{.index = index});
        offer<SetKnot, RemoveKnot>();
        add(DeleteKnot{.index = index});
        group();
        if (const core::Curve* curve = state_.active_curve()) {
            const double u = curve->knots().stored()[index];
            if (curve->domain().contains(u)) add(ShowHandlebar{.u = u});
        }
        joint_marks();
        offer<SelectNone>();
    }

    /// Of the selected knot, or of the place of the handlebar.
    void joint_marks() {
        group();
        using enum core::JointMark;
        offer<MarkAs<corner>, MarkAs<smooth>, MarkAs<curvature>, UnmarkJoint>();
        group();
    }

    void place_on_curve(double u) {
        add(InsertKnot{.u = u});
        add(Split{.u = u});
        add(SetParameter{.u = u});
        add(ShowHandlebar{.u = u});
        group();
    }

    void leg(std::size_t index, core::Point position) {
        const std::size_t count = state_.active_curve()->control_points().size();
        add(AddPoint{.index = index + 1, .position = position});
        add(SelectPoints{.points = {index, (index + 1) % count}});
        group();
        curve();
    }

    /// What is selected over several curves.
    void several_curves() {
        if (!state_.selection.is_over_curves()) return;
        offer<Delete, HideCurves, LockCurves, ColorCurves>();
        group();
        offer<GroupCurves, UngroupCurves>();
        group();
    }

    /// The active curve as a whole.
    void curve() {
        several_curves();
        offer<Cut, Copy, CopyAs, PasteBeside, Duplicate, DeleteCurve>();
        group();
        offer<RenameCurve, Reverse, Elevate, SetKind, CloseOrOpen>();
        group();
        const core::Document& document = state_.shown();
        if (const core::DocumentCurve* active = document.active_curve()) {
            add(SetCurveVisible{.index = document.active, .visible = !active->visible});
            add(SetCurveLocked{.index = document.active, .locked = !active->locked});
        }
    }

    void canvas() {
        if (state_.tool == Tool::draw_curve) pens();
        offer<TakeTool<Tool::draw_curve>, TakeTool<Tool::select>, PasteBeside, SelectAll>();
        group();
        offer<FitView, ZoomIn, ZoomOut>();
        group();
        offer<ToggleOverlay<Overlay::polygon>, ToggleOverlay<Overlay::knots>, ToggleOverlay<Overlay::labels>,
              ToggleOverlay<Overlay::grid>, ToggleOverlay<Overlay::construction>>();
        group();
        panels();
    }

    void guide(std::size_t index) {
        add(RemoveGuide{.index = index});
        offer<MoveGuide, AddGuide, RemoveGuides>();
    }

    void plot(double u) {
        if (state_.active_curve() != nullptr && state_.active_curve()->domain().contains(u)) place_on_curve(u);
        offer<TogglePlay, FitPlot, SetKnotMove, ToggleDock>();
    }

    void cell(std::size_t level) {
        add(SetLevel{.level = static_cast<int>(level)});
        offer<PreviousLevel, NextLevel>();
        group();
        offer<InsertKnot, Split>();
        group();
        offer<ToggleOverlay<Overlay::construction>>();
    }

    void finding(const Finding& finding, const std::string& text) {
        if (finding.parameter) place_on_curve(*finding.parameter);
        add(CopyText{.text = text});
        offer<ClearFindings>();
    }

    void text(const std::string& text) {
        add(CopyText{.text = text});
        if (text == state_.message.text && state_.message.is_error) add(DismissMessage{});
    }

    void title_line() {
        const core::Document& document = state_.shown();
        add(CopyText{.text = fmt::format("{}\n{}", document.title, document.description)});
        offer<ToggleTitle>();
    }

    void tools() {
        for (const Tool tool : all_tools) entries_.push_back({&take_tool_spec(tool)});
        group();
        offer<Undo, Redo>();
        group();
        panels();
    }

    void shapes() {
        for (std::size_t i = 0; i < shape_kind_count; ++i) put({&draw_shape_spec(static_cast<ShapeKind>(i))});
        group();
        offer<SetPolygonSides>();
    }

    void joints() {
        for (std::size_t i = 0; i < joint_operation_count; ++i)
            put({&joint_operation_spec(static_cast<JointOperation>(i))});
        group();
        for (std::size_t i = 0; i < joint_continuity_count; ++i)
            put({&joint_continuity_spec(static_cast<core::GeometricContinuity>(i))});
        group();
        offer<SetJointRadius, SetJointOffset, CheckJoints>();
    }

    void brushes() {
        for (std::size_t i = 0; i < brush_kind_count; ++i) put({&use_brush_spec(static_cast<BrushKind>(i))});
        group();
        offer<SetBrushSize, RefairPart>();
    }

    void snapping() {
        for (std::size_t i = 0; i < snap_kind_count; ++i)
            put({.spec = &toggle_snap_spec(static_cast<SnapKind>(i)), .stays_open = true});
        group();
        offer<SetAngleStep, AddGuide, RemoveGuides>();
    }

    void panels() { offer<ToggleTitle, ToggleInspector, ToggleDock, TogglePresenting>(); }

    void interface() {
        panels();
        group();
        offer<ToggleTheme, ScaleUp, ScaleDown, ResetScale>();
        group();
        offer<TogglePalette, ToggleKeySheet>();
    }

  private:
    void group() { begins_group_ = !entries_.empty(); }

    void put(MenuEntry entry) {
        entry.begins_group = std::exchange(begins_group_, false);
        entries_.push_back(std::move(entry));
    }

    void add(const Command& command) { put({&command.spec(), command}); }

    template <class... Commands>
    void offer() {
        (put({&Commands::spec()}), ...);
    }

    const EditorState& state_;
    std::vector<MenuEntry> entries_;
    bool begins_group_ = false;
};

/// One case for each thing that can be hovered; what is no such thing says so by false.
struct FillByHit {
    Menu& menu;

    bool operator()(const HoveredPoint&) const { return menu.points(), true; }
    bool operator()(const HoveredWeightRing&) const { return menu.points(), true; }
    bool operator()(const HoveredBasis&) const { return menu.points(), true; }
    bool operator()(const HoveredKnot& hit) const { return menu.knot(hit.index), true; }
    bool operator()(const HoveredFitPoint&) const { return menu.fit_point(), true; }
    bool operator()(const HoveredFitHandle&) const { return menu.fit_point(), true; }
    bool operator()(const HoveredCell& hit) const { return menu.cell(hit.level), true; }
    bool operator()(const HoveredGuide& hit) const { return menu.guide(hit.index), true; }
    bool operator()(const HoveredOtherPoint&) const { return menu.curve(), true; }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
};

/// One case for each target.
struct FillByTarget {
    const EditorState& state;
    Menu& menu;

    void operator()(const OnCanvas& target) const {
        if (std::holds_alternative<HoveredOtherCurve>(target.hit)) return menu.curve();
        if (!is_in(target.hit, state.shown())) return menu.canvas();
        if (fill_by(target.hit)) return;
        if (const auto* leg = std::get_if<HoveredLeg>(&target.hit)) return menu.leg(leg->index, target.position);
        if (const auto* curve = std::get_if<HoveredCurve>(&target.hit)) return place_on_curve(curve->u);
        if (std::holds_alternative<HoveredParameter>(target.hit)) return place_on_curve(state.parameter());
        if (std::holds_alternative<HoveredHandlebar>(target.hit) && state.selection.handlebar) {
            menu.joint_marks();
            return place_on_curve(*state.selection.handlebar);
        }
        menu.canvas();
    }
    void operator()(const OnPlot& target) const {
        if (!fill_by(target.hit)) menu.plot(target.u);
    }
    void operator()(const OnPart& target) const {
        if (!fill_by(target.hit)) menu.interface();
    }
    void operator()(const OnCurve&) const { menu.curve(); }
    void operator()(const OnFinding& target) const {
        if (state.findings && target.index < state.findings->rows.size())
            menu.finding(state.findings->rows[target.index], target.text);
        else
            menu.interface();
    }
    void operator()(const OnText& target) const { menu.text(target.text); }
    void operator()(const OnTitleLine&) const { menu.title_line(); }
    void operator()(const OnToolBar&) const { menu.tools(); }
    void operator()(const OnShapes&) const { menu.shapes(); }
    void operator()(const OnPens&) const { menu.pens(); }
    void operator()(const OnJoints&) const { menu.joints(); }
    void operator()(const OnBrushes&) const { menu.brushes(); }
    void operator()(const OnSnapping&) const { menu.snapping(); }
    void operator()(const OnPanel&) const { menu.interface(); }

  private:
    bool fill_by(const Hover& hit) const { return is_in(hit, state.shown()) && std::visit(FillByHit{menu}, hit); }

    void place_on_curve(double u) const {
        menu.place_on_curve(u);
        menu.curve();
    }
};

void select_point(const EditorState& state, std::size_t index, CommandQueue& queue) {
    if (!state.selection.contains_point(index)) queue.run(SelectPoints{.points = {index}});
}

// What is selected together stays so.
void make_active(const EditorState& state, std::size_t index, CommandQueue& queue) {
    if (part_of(selected_parts(state), index) != nullptr) return;
    if (index != state.history.present().active) queue.run(ActivateCurve{.index = index});
}

void select_hit(const EditorState& state, const Hover& hit, CommandQueue& queue) {
    if (const auto* point = std::get_if<HoveredPoint>(&hit)) select_point(state, point->index, queue);
    if (const auto* ring = std::get_if<HoveredWeightRing>(&hit)) select_point(state, ring->index, queue);
    if (const auto* basis = std::get_if<HoveredBasis>(&hit)) select_point(state, basis->index, queue);
    if (const auto* knot = std::get_if<HoveredKnot>(&hit)) queue.run(SelectKnot{.index = knot->index});
    if (const auto* point = std::get_if<HoveredFitPoint>(&hit)) queue.run(SelectFitPoint{.index = point->index});
    if (const auto* handle = std::get_if<HoveredFitHandle>(&hit)) queue.run(SelectFitPoint{.index = handle->index});
    if (const auto* curve = std::get_if<HoveredOtherCurve>(&hit)) make_active(state, curve->index, queue);
    if (const auto* point = std::get_if<HoveredOtherPoint>(&hit)) make_active(state, point->curve, queue);
}

}  // namespace

void select_for_menu(const EditorState& state, const MenuTarget& target, CommandQueue& queue) {
    if (const auto* canvas = std::get_if<OnCanvas>(&target)) select_hit(state, canvas->hit, queue);
    if (const auto* plot = std::get_if<OnPlot>(&target)) select_hit(state, plot->hit, queue);
    if (const auto* part = std::get_if<OnPart>(&target)) select_hit(state, part->hit, queue);
    if (const auto* curve = std::get_if<OnCurve>(&target)) make_active(state, curve->index, queue);
}

std::vector<MenuEntry> context_menu(const EditorState& state, const MenuTarget& target) {
    Menu menu(state);
    std::visit(FillByTarget{state, menu}, target);
    return menu.take();
}

}  // namespace batten::editor
