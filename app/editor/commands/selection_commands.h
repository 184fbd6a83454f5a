/// Commands on the selection and on which curve is active.
#pragma once

#include <optional>

#include "app/editor/command.h"

namespace batten::editor {

struct SelectAll {
    static const CommandSpec& spec();
};

struct SelectNone {
    static const CommandSpec& spec();
};

struct SelectPoints {
    std::vector<std::size_t> points;
    static const CommandSpec& spec();
};

struct SelectKnot {
    std::optional<std::size_t> index;
    static const CommandSpec& spec();
};

/// Holds the active curve at a parameter: its point and its tangent can be dragged there.
struct ShowHandlebar {
    double u;
    static const CommandSpec& spec();
};

struct ActivateCurve {
    std::size_t index;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
