#include "app/editor/state/picture_gauge.h"

#include "app/editor/commands/picture_commands.h"
#include "app/editor/state/show_dialog.h"
#include "app/editor/state/state.h"

namespace batten::editor {

bool is_gauging(const EditorState& state) {
    return state.gauge && state.gauge->points.size() < 2;
}

void add_gauge_point(EditorState& state, core::Point point) {
    if (!is_gauging(state)) return;
    state.gauge->points.push_back(point);
    if (is_gauging(state)) return;
    const PictureGauge complete = *state.gauge;
    state.message = {};  // which asked for the clicks
    show_dialog(state, Dialog::command_form);
    state.form = &ScalePicture::spec();
    state.gauge = complete;
}

}  // namespace batten::editor
