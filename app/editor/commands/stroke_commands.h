/// Commands about strokes of a pencil.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct FitStroke {
    std::vector<core::Point> points;
    int smoothness;
    double pixel;  ///< how large one is
    static const CommandSpec& spec();
};

/// Fits the stroke of the last step anew; no step of its own.
struct RefitStroke {
    int smoothness;
    static const CommandSpec& spec();
};

struct Redraw {
    std::vector<core::Point> points;
    int smoothness;
    double pixel;
    static const CommandSpec& spec();
};

/// Refusal: the last step came of no stroke.
std::optional<Refusal> no_stroke(const EditorState& state);

}  // namespace batten::editor
