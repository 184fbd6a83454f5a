/// Commands that trace the outlines in a picture.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/command.h"

namespace batten::editor {

struct TracePicture {
    std::size_t picture;
    std::optional<double> threshold;  ///< 0 to 255; none: midway between dark and light
    double tolerance;                 ///< pixels of the picture
    double speckle;                   ///< pixels of area
    bool inverted;
    static const CommandSpec& spec();
};

/// The same for a file, in pixels from its lower left corner.
struct TraceFile {
    std::filesystem::path path;
    std::optional<double> threshold;
    double tolerance;
    double speckle;
    bool inverted;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
