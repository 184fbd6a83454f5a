/// A curve on the canvas with a pointer over it.
#pragma once

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor::test {

using Indices = std::vector<std::size_t>;

/// At the camera's start 64 px are a unit and (0, 0) is at (640, 360).
inline glm::dvec2 px(double x, double y) {
    return {640.0 + 64.0 * x, 360.0 - 64.0 * y};
}

/// The zigzag of degree 2 on the canvas; see test::zigzag_editor.
class CanvasFixture : public testing::Test {
  protected:
    const EditorState& state() const { return editor.state(); }
    core::Point point(std::size_t i) const { return committed(editor).control_points()[i]; }
    double weight(std::size_t i) const { return committed(editor).weights()[i]; }
    std::size_t steps() const { return state().history.undo_count() - first_steps; }
    const Indices& selected() const { return state().selection.points; }
    /// Types at a place; '\t', '\b' and '\n' are Tab, Backspace and Enter.
    void type(const std::u32string& text, glm::dvec2 at) {
        for (const char32_t c : text) {
            PointerEvent event;
            event.action = PointerAction::key;
            event.position_px = at;
            if (c == U'\t')
                event.key = Key::tab;
            else if (c == U'\b')
                event.key = Key::backspace;
            else if (c == U'\n')
                event.key = Key::enter;
            else
                event.character = c;
            pointer.send(event);
        }
    }
    template <class Mode>
    bool is_in() const {
        return std::holds_alternative<Mode>(pointer.mode());
    }

    Editor editor = test::zigzag_editor();
    std::size_t first_steps = editor.state().history.undo_count();
    std::shared_ptr<const core::Curve> first_curve = editor.state().history.present().active_curve()->curve;
    test::CanvasPointer pointer{editor, test::CanvasStep{}};
};

}  // namespace batten::editor::test
