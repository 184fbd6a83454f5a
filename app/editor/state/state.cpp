#include "app/editor/state/state.h"

#include <utility>

namespace batten::editor {

double EditorState::parameter() const {
    const core::Curve* curve = active_curve();
    return curve == nullptr ? view.parameter : curve->knots().into_domain(view.parameter);
}

std::string EditorState::file_name() const {
    const std::filesystem::path& file = path.empty() ? source : path;
    return file.empty() ? "untitled" : file.filename().string();
}

void take_tool(EditorState& state, Tool tool) {
    if (std::exchange(state.axis_pick, std::nullopt)) state.preview.reset();
    if (state.tool == tool) return;
    state.tool = tool;
    ++state.tool_changes;
    // What was begun with the other tool is left, with all that it shows.
    state.placing = {};
    if (std::holds_alternative<HoveredGrip>(state.hover)) state.hover = HoveredNothing{};
    if (std::exchange(state.preview, std::nullopt)) state.ghost.reset();
}

}  // namespace batten::editor
