#include "app/editor/state/state.h"

namespace batten::editor {

double EditorState::parameter() const {
    const core::Curve* curve = active_curve();
    return curve == nullptr ? view.parameter : curve->knots().into_domain(view.parameter);
}

std::string EditorState::file_name() const {
    return path.empty() ? "untitled" : path.filename().string();
}

void take_tool(EditorState& state, Tool tool) {
    if (state.tool != tool) {
        ++state.tool_changes;
        state.placing = {};
    }
    state.tool = tool;
}

}  // namespace batten::editor
