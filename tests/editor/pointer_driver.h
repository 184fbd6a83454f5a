/// Drives an editor with pointer events, as the window does: step the mode, run what it asks for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/editor.h"
#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/plot_mode.h"

namespace batten::editor::test {

/// A state that shows `definition` as its only curve. The definition must be valid.
inline EditorState state_with(core::CurveDefinition definition) {
    core::Document document;
    core::DocumentCurve item;
    item.name = "curve";
    item.curve = std::make_shared<const core::Curve>(core::Curve::make(std::move(definition)).value());
    document.curves.push_back(item);
    EditorState state;
    state.history = History(document);
    return state;
}

/// The cubic of the worked example: seven points, knots 0,0,0,0,1/4,1/2,3/4,1,1,1,1.
inline core::CurveDefinition cubic() {
    core::CurveDefinition definition;
    definition.degree = 3;
    definition.knots = {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1};
    definition.points = {{-6, -2.2}, {-4.6, 2.6}, {-1.6, 3.6}, {-0.4, -2.6}, {2.6, -3.2}, {3.4, 2.2}, {6.2, 2.8}};
    return definition;
}

/// Six points on a regular path, cubic and periodic with knots 0..6.
inline core::CurveDefinition closed_cubic() {
    core::CurveDefinition definition;
    definition.degree = 3;
    definition.knots = {0, 1, 2, 3, 4, 5, 6};
    definition.points = {{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}};
    definition.periodic = true;
    return definition;
}

/// The zigzag: degree 2, points (-4,-2) (-2,2) (0,-2) (2,2) (4,-2), knots 0,0,0,1,2,3,3,3. Its knots lie on the middles
/// of two legs, C(1) = (-1, 0) and C(2) = (1, 0); C(1.5) = (0, -1) where u stands at first. Drawn by commands.
inline Editor zigzag_editor() {
    Editor editor;
    editor.run(NewCurve{.points = {{-4, -2}, {-2, 2}, {0, -2}, {2, 2}, {4, -2}}, .degree = 2});
    editor.run(SetKnots{.knots = {0, 0, 0, 1, 2, 3, 3, 3}});
    editor.run(SetParameter{.u = 1.5});
    return editor;
}

inline constexpr Modifiers ctrl{true, false, false};
inline constexpr Modifiers shift{false, true, false};
inline constexpr Modifiers alt{false, false, true};

/// The pointer on one of the two pictures. `Step` has an operator()(mode, event, state, queue) that gives the mode
/// after it.
template <class Mode, class Step>
class Pointer {
  public:
    Pointer(Editor& editor, Step step) : editor_(editor), step_(step) {}

    Modifiers modifiers;
    bool space = false;
    PointerButton button = PointerButton::left;

    void send(PointerAction action, glm::dvec2 position, double wheel = 0.0) {
        const bool has_button =
            action == PointerAction::press || action == PointerAction::release || action == PointerAction::double_click;
        CommandQueue queue;
        mode_ = step_(
            mode_, PointerEvent{action, position, has_button ? button : PointerButton::none, modifiers, space, wheel},
            editor_.state(), queue);
        was_asked_ = !queue.is_empty();
        editor_.perform(queue);
    }
    /// Any event as it is.
    void send(const PointerEvent& event) {
        CommandQueue queue;
        mode_ = step_(mode_, event, editor_.state(), queue);
        was_asked_ = !queue.is_empty();
        editor_.perform(queue);
    }
    /// Turns a wheel to the left, with so many notches upward at the same time.
    void turn_sideways(glm::dvec2 position, double notches, double upward = 0.0) {
        PointerEvent event{PointerAction::wheel, position, PointerButton::none, modifiers, space, upward};
        event.sideways_wheel = notches;
        CommandQueue queue;
        mode_ = step_(mode_, event, editor_.state(), queue);
        editor_.perform(queue);
    }
    void press(glm::dvec2 at) { send(PointerAction::press, at); }
    void move(glm::dvec2 at) { send(PointerAction::move, at); }
    void release(glm::dvec2 at) { send(PointerAction::release, at); }
    void escape(glm::dvec2 at) { send(PointerAction::escape, at); }
    void double_click(glm::dvec2 at) {
        press(at);
        release(at);
        send(PointerAction::double_click, at);
        release(at);
    }
    void click(glm::dvec2 at) {
        press(at);
        release(at);
    }
    /// Press, two moves, release.
    void drag(glm::dvec2 from, glm::dvec2 to) {
        press(from);
        move(from + 0.4 * (to - from));
        move(to);
        release(to);
    }

    const Mode& mode() const { return mode_; }
    bool was_asked() const { return was_asked_; }  ///< whether the last event asked the editor for anything

  private:
    Editor& editor_;
    Step step_;
    Mode mode_;
    bool was_asked_ = false;
};

struct CanvasStep {
    CanvasMode operator()(const CanvasMode& mode, const PointerEvent& event, const EditorState& state,
                          CommandQueue& queue) const {
        return step_canvas(mode, event, state, queue);
    }
};

struct PlotStep {
    glm::dvec2 size_px{1000.0, 260.0};

    PlotMode operator()(const PlotMode& mode, const PointerEvent& event, const EditorState& state,
                        CommandQueue& queue) const {
        return step_plot(mode, event, state, size_px, queue);
    }
};

using CanvasPointer = Pointer<CanvasMode, CanvasStep>;
using PlotPointer = Pointer<PlotMode, PlotStep>;

/// The committed active curve.
inline const core::Curve& committed(const Editor& editor) {
    return *editor.state().history.present().active_curve()->curve;
}

inline std::vector<double> stored_knots(const core::Curve& curve) {
    return {curve.knots().stored().begin(), curve.knots().stored().end()};
}

}  // namespace batten::editor::test
