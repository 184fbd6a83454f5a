#include "app/editor/hint_text.h"

#include "app/editor/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

std::string parameter_text(const EditorState& state) {
    return core::sentence("u = {u}", {{"u", number_text(state.parameter())}});
}

std::string locked_sentence(const core::DocumentCurve& curve) {
    return core::sentence("curve '{name}' is locked; unlock it in the inspector", {{"name", curve.name}});
}

}  // namespace batten::editor
