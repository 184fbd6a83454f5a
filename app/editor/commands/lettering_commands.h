/// The command that makes curves of letters.
#pragma once

#include <filesystem>
#include <string>

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// The outlines of the letters in a font file, as closed curves.
struct TextOutlines {
    std::filesystem::path path;
    std::string text;
    core::Point position;  ///< of the left end of the base line
    double size = 1.0;     ///< of the em, above 0
    static const CommandSpec& spec();
};

}  // namespace batten::editor
