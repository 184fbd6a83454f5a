#include "app/editor/state/dialog.h"

namespace batten::editor {

void show_dialog(EditorState& state, Dialog dialog) {
    state.dialog = dialog;
    state.pending.reset();
}

}  // namespace batten::editor
