/// A hand that drags, draws and types at random, for tests of whole sessions.
#pragma once

#include <random>

#include "tests/editor/pointer_driver.h"

namespace batten::editor::test {

/// Drags what it finds on the canvas, and draws, with snapping, modifiers and typed numbers; the same seed does the
/// same on every system.
class RandomHand {
  public:
    RandomHand(Editor& editor, unsigned seed) : editor_(editor), generator_(seed) {}

    /// One gesture, from the press to the release or to what ends it else; another curve may be active before.
    void gesture();

  private:
    std::size_t below(std::size_t count) { return generator_() % count; }
    glm::dvec2 somewhere();
    glm::dvec2 at(core::Point place) const;
    core::Point grip();
    void type_place(glm::dvec2 place);
    void drag();
    void drag_guide();
    void double_click_fit_curve();
    void draw_with_pen();
    void draw_shape();
    void draw_stroke();
    void use_joint_tool();

    Editor& editor_;
    std::mt19937 generator_;
    CanvasPointer pointer_{editor_, CanvasStep{}};
};

}  // namespace batten::editor::test
