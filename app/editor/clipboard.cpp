#include "app/editor/clipboard.h"

namespace batten::editor {

std::string read_clipboard(const EditorState& state) {
    return state.desktop.read_clipboard ? state.desktop.read_clipboard() : state.clipboard;
}

void write_clipboard(EditorState& state, const std::string& text) {
    state.clipboard = text;
    if (state.desktop.write_clipboard) state.desktop.write_clipboard(text);
}

}  // namespace batten::editor
