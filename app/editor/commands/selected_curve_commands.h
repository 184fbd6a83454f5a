/// Commands on several curves at once: what is selected of them, hidden, locked, colored and deleted together.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command.h"
#include "core/document/document.h"

namespace batten::editor {

struct SelectParts {
    std::string parts;  ///< as text_of_parts() writes them
    static const CommandSpec& spec();
};

struct SelectAllCurves {
    static const CommandSpec& spec();
};

struct InvertSelection {
    static const CommandSpec& spec();
};

struct HideCurves {
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

struct ShowCurves {
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

struct LockCurves {
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

struct UnlockCurves {
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

struct ColorCurves {
    std::vector<std::size_t> curves;
    std::optional<core::DocumentColor> color;  ///< none: the theme's
    static const CommandSpec& spec();
};

struct DeleteCurves {
    std::vector<std::size_t> curves;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
