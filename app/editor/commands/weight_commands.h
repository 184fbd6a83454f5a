/// Commands on the ratios of weights of the active curve.
#pragma once

#include "app/editor/command.h"

namespace batten::editor {

struct MoveFarinPoint {
    std::size_t leg;  ///< by the control point where it begins
    double share;     ///< of the leg that lies before it, above 0 and below 1
    static const CommandSpec& spec();
};

struct MakeCircular {
    double u;  ///< in the piece that becomes an arc of a circle
    static const CommandSpec& spec();
};

/// From where the lifted curve is seen.
struct SetOrbit {
    double yaw;    ///< degrees around the vertical, counterclockwise
    double pitch;  ///< degrees of elevation, from -90 to 90
    double zoom;   ///< 1 where all of it is seen
    static const CommandSpec& spec();
};

}  // namespace batten::editor
