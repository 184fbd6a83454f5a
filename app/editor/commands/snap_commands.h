/// Commands on what the pointer snaps to, and on guides.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/snap_kind.h"

namespace batten::editor {

/// One switch for each kind, for the menu and the tool bar.
const CommandSpec& toggle_snap_spec(SnapKind kind);

template <SnapKind kind>
struct ToggleSnap {
    static const CommandSpec& spec() { return toggle_snap_spec(kind); }
};

struct SetSnap {
    SnapKind kind;
    bool on;
    static const CommandSpec& spec();
};

struct SetAngleStep {
    double degrees;
    static const CommandSpec& spec();
};

struct AddGuide {
    core::Point position;
    double angle;
    static const CommandSpec& spec();
};

struct MoveGuide {
    std::size_t index;
    core::Point position;
    static const CommandSpec& spec();
};

struct RemoveGuide {
    std::size_t index;
    static const CommandSpec& spec();
};

struct RemoveGuides {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
