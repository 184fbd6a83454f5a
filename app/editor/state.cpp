#include "app/editor/state.h"

namespace batten::editor {

double EditorState::parameter() const {
    const core::Curve* curve = active_curve();
    return curve == nullptr ? view.parameter : curve->knots().into_domain(view.parameter);
}

std::string EditorState::file_name() const {
    return path.empty() ? "untitled" : path.filename().string();
}

}  // namespace batten::editor
