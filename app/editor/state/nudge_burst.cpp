#include "app/editor/state/nudge_burst.h"

#include "app/editor/state/state.h"

namespace batten::editor {

namespace {

constexpr double longest_pause = 1.0;  // seconds

bool moves_the_same(const EditorState& state) {
    return state.burst && state.burst->selection == state.selection;
}

}  // namespace

bool continues_burst(const EditorState& state) {
    if (!moves_the_same(state) || !state.now || !state.burst->time) return false;
    return *state.now - *state.burst->time < longest_pause;
}

NudgeBurst burst_after(const EditorState& state, core::Vector offset, bool continues) {
    NudgeBurst burst{state.selection};
    if (continues && moves_the_same(state)) burst = *state.burst;
    burst.total += offset;
    ++burst.count;
    burst.time = state.now;
    return burst;
}

}  // namespace batten::editor
