#include "app/editor/pointer/hover_request.h"

namespace batten::editor {

void request_hover(const Hover& hover, const EditorState& state, CommandQueue& queue) {
    if (hover != state.hover) queue.change(SetHover{hover});
}

}  // namespace batten::editor
