#include "app/editor/findings.h"

#include "app/editor/state.h"

namespace batten::editor {

void show_findings(EditorState& state, Findings findings) {
    state.message = {findings.summary, false};
    state.findings = std::move(findings);
}

}  // namespace batten::editor
