/// Commands about the brush: what it does, its size, and the part that it faired last.
#pragma once

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "app/editor/state/brush.h"

namespace batten::editor {

/// Takes the brush of one kind.
template <BrushKind kind>
struct UseBrush {
    static const CommandSpec& spec();
};

template <>
const CommandSpec& UseBrush<BrushKind::soft_move>::spec();
template <>
const CommandSpec& UseBrush<BrushKind::fair>::spec();

struct SetBrushSize {
    double radius;  ///< design pixels
    static const CommandSpec& spec();
};

/// Fairs the part that the last step faired by another distance; no step of its own.
struct RefairPart {
    double distance;
    static const CommandSpec& spec();
};

/// The command that takes the brush of this kind.
const CommandSpec& use_brush_spec(BrushKind kind);

/// How far the fairing brush may move the active curve: as was chosen last, else a hundredth of its size.
double brush_distance(const EditorState& state);

/// Refusal: the last step faired no part.
std::optional<Refusal> no_faired_part(const EditorState& state);

}  // namespace batten::editor
