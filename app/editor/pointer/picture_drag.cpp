#include "app/editor/pointer/picture_drag.h"

#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/pointer/edit_step.h"
#include "app/editor/pointer/point_drag.h"

namespace batten::editor {

namespace {

void ask_to_move_picture(const DraggingPicture& mode, const Gesture& gesture, Phase phase) {
    const std::vector<core::Picture>& pictures = gesture.state.history.present().pictures;
    if (mode.index >= pictures.size()) return;
    const core::Point start = pictures[mode.index].position;
    const core::Point target = dragged_position(gesture, start, mode.press_px);
    if (target == start)
        gesture.queue.cancel_preview();
    else
        request(gesture, phase, MovePicture{.picture = mode.index, .position = target});
}

}  // namespace

CanvasMode step(const DraggingPicture& mode, const Gesture& gesture) {
    // A click on a picture means no more than one beside it.
    return step_edit(mode, gesture, ask_to_move_picture, [](const auto&, const Gesture& click) {
        if (click.state.selection != Selection{}) click.queue.run(SelectNone{});
    });
}

std::optional<std::size_t> picture_at(const EditorState& state, glm::dvec2 position_px) {
    const core::Point point(render::world_from_screen(state.view.camera, position_px));
    const std::vector<core::Picture>& pictures = state.shown().pictures;
    for (std::size_t i = pictures.size(); i-- > 0;) {
        const core::Picture& picture = pictures[i];
        const core::PicturePlace place = core::picture_from_plane(picture, point);
        const bool is_inside =
            place.x >= 0.0 && place.y >= 0.0 && place.x <= picture.width && place.y <= picture.height;
        if (picture.visible && !picture.locked && is_inside) return i;
    }
    return std::nullopt;
}

}  // namespace batten::editor
