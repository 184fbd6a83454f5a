/// Commands on the parameter u and on the construction shown there.
#pragma once

#include <optional>

#include "app/editor/command.h"

namespace batten::editor {

struct SetParameter {
    double u;
    static const CommandSpec& spec();
};

struct StepParameterBack {
    static const CommandSpec& spec();
};

struct StepParameterForward {
    static const CommandSpec& spec();
};

struct TogglePlay {
    static const CommandSpec& spec();
};

struct TogglePingPong {
    static const CommandSpec& spec();
};

struct SetBlossomValues {
    bool by_value;  ///< f(0, 0, 1/4), else f(u_3, u_4, u_5)
    static const CommandSpec& spec();
};

struct SetSpeed {
    double speed;  ///< fifths of the domain per second
    static const CommandSpec& spec();
};

struct SetLevel {
    std::optional<int> level;  ///< the last one shown; none: all
    static const CommandSpec& spec();
};

struct PreviousLevel {
    static const CommandSpec& spec();
};

struct NextLevel {
    static const CommandSpec& spec();
};

}  // namespace batten::editor
