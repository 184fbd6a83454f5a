// What must not compile, one case at a time; case 0 must.

#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"

namespace batten::editor {

Command example() {
#if MISUSE == 0
    return MoveKnot{.index = 5, .u = 0.5, .mode = core::KnotMove::snap};
#elif MISUSE == 1
    return MoveKnot{.index = 5, .u = 0.5};
#elif MISUSE == 2
    return MoveKnot{.index = 5, .u = "0.5", .mode = core::KnotMove::snap};
#elif MISUSE == 3
    return MoveKnot{.index = 5, .u = 0.5, .mode = core::KnotMove::snap, .angle = 1.0};
#elif MISUSE == 4
    return MovePoints{.points = {1}, .offset = core::Point(1.0, 2.0)};
#endif
}

}  // namespace batten::editor
