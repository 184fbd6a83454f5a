#include "app/editor/commands/snap_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/modes.h"
#include "app/editor/pointer/point_drag.h"

namespace batten::editor {
namespace {

void ask_to_move_guide(const DraggingGuide& mode, const Gesture& gesture, Phase phase) {
    const auto& guides = gesture.state.history.present().guides;
    if (mode.index >= guides.size()) return;
    const core::Point start = guides[mode.index].point;
    const core::Point target = dragged_position(gesture, start, mode.press_px, {.guide = mode.index});
    if (target == start)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, MoveGuide{.index = mode.index, .position = target});
}

}  // namespace

CanvasMode begin_guide_drag(const Gesture& gesture, std::size_t index) {
    return DraggingGuide{index, gesture.event.position_px};
}

CanvasMode step(const DraggingGuide& mode, const Gesture& gesture) {
    return step_edit(mode, gesture, ask_to_move_guide, [](const auto&, const Gesture&) {});
}

}  // namespace batten::editor
