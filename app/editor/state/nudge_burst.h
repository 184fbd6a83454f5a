/// Nudges that follow each other at once, which are one step of the history.
#pragma once

#include <optional>

#include "app/editor/state/selection.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct EditorState;

struct NudgeBurst {
    Selection selection;
    core::Vector total{0.0, 0.0};  ///< of all nudges
    std::size_t count = 0;         ///< of nudges
    std::optional<double> time{};  ///< EditorState::now at the last one
};

/// Whether a nudge now would belong to the step before: nothing else was done since, and a second has not passed.
bool continues_burst(const EditorState& state);

/// The burst after what is selected is nudged by `offset`: a new one, or the one under way where the nudge
/// `continues` it and moves the same.
NudgeBurst burst_after(const EditorState& state, core::Vector offset, bool continues);

}  // namespace batten::editor
