/// Commands on the knots of the active curve, one at a time or all of them.
#pragma once

#include "app/editor/command.h"
#include "core/curve/knot_vector.h"
#include "core/edit/knot_edit.h"

namespace batten::editor {

struct InsertKnot {
    double u;
    static const CommandSpec& spec();
};

struct InsertMidpoints {
    static const CommandSpec& spec();
};

struct RaiseKnot {
    std::size_t index;
    static const CommandSpec& spec();
};

struct MoveKnot {
    std::size_t index;
    double u;
    core::KnotMove mode;
    std::optional<double> snap_distance{};  ///< in parameter units; not for stop
    static const CommandSpec& spec();
};

struct SetKnot {
    std::size_t index;
    double u;
    static const CommandSpec& spec();
};

struct DeleteKnot {
    std::size_t index;
    static const CommandSpec& spec();
};

struct SetKnots {
    std::vector<double> knots;
    static const CommandSpec& spec();
};

struct SetKind {
    core::KnotKind kind;
    static const CommandSpec& spec();
};

struct ToggleClosed {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
