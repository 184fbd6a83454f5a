#include "app/editor/pointer/hint_text.h"

#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "core/base/sentence.h"

namespace batten::editor {

std::string current_parameter(const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    return curve == nullptr ? number_text(state.parameter()) : parameter_text(*curve, state.parameter());
}

std::string parameter_text(const EditorState& state) {
    return core::sentence("u = {u}", {{"u", current_parameter(state)}});
}

std::string locked_sentence(const core::DocumentCurve& curve) {
    return core::sentence("curve '{name}' is locked; unlock it in the inspector", {{"name", curve.name}});
}

std::string hidden_sentence(const core::DocumentCurve& curve) {
    return core::sentence("curve '{name}' is hidden; show it in the inspector, or all with Ctrl+Shift+H",
                          {{"name", curve.name}});
}

}  // namespace batten::editor
