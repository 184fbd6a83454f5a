#include "app/editor/state/show_dialog.h"

namespace batten::editor {

void show_dialog(EditorState& state, Dialog dialog) {
    state.dialog = dialog;
    // With two points clicked, only the form that asks for their distance needs them.
    if (!is_gauging(state)) state.gauge.reset();
    state.pending.reset();
}

}  // namespace batten::editor
