/// Commands that show and close dialogs and messages.
#pragma once

#include <array>

#include "app/editor/command.h"
#include "core/base/names.h"

namespace batten::editor {

/// What Escape gives up, the most fleeting first.
enum class Escapable { dialog, preview, tool, findings, selection, presentation };

/// Each of these closes its dialog again where it is open.
struct TogglePalette {
    static const CommandSpec& spec();
};
struct ToggleKeySheet {
    static const CommandSpec& spec();
};
struct ToggleWelcome {
    static const CommandSpec& spec();
};
struct ToggleAbout {
    static const CommandSpec& spec();
};

struct CloseDialog {
    static const CommandSpec& spec();
};

struct DismissMessage {
    static const CommandSpec& spec();
};

struct ClearFindings {
    static const CommandSpec& spec();
};

struct Escape {
    Escapable what;
    static const CommandSpec& spec();
};

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::Escapable> {
    using enum editor::Escapable;
    static constexpr std::array table{Named{dialog, "dialog", "dialog"},
                                      Named{preview, "preview", "preview"},
                                      Named{tool, "tool", "tool"},
                                      Named{findings, "findings", "findings"},
                                      Named{selection, "selection", "selection"},
                                      Named{presentation, "presentation", "presentation"}};
};

}  // namespace batten::core
