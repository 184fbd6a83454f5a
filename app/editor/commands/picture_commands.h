/// Commands about pictures below the curves: adding, placing, scaling, dimming, locking and tracing them.
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/command.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct EditorState;

struct ChoosePicture {
    static const CommandSpec& spec();
};

struct AddPicture {
    std::filesystem::path path;
    core::Point center;
    double width;  ///< in the plane
    double opacity;
    static const CommandSpec& spec();
};

/// The picture in the middle of what is seen, a little smaller than that.
AddPicture picture_in_view(const EditorState& state, const std::filesystem::path& path);

struct RemovePicture {
    std::size_t picture;
    static const CommandSpec& spec();
};

struct MovePicture {
    std::size_t picture;
    core::Point position;
    static const CommandSpec& spec();
};

struct PlacePicture {
    std::size_t picture;
    core::Point position;
    double width;
    double rotation;  ///< degrees
    static const CommandSpec& spec();
};

struct MeasurePicture {
    std::size_t picture;
    static const CommandSpec& spec();
};

struct ScalePicture {
    std::size_t picture;
    core::Point from;
    core::Point to;
    double length;
    static const CommandSpec& spec();
};

struct DimPicture {
    std::size_t picture;
    double opacity;
    static const CommandSpec& spec();
};

struct LockPicture {
    std::size_t picture;
    bool locked;
    static const CommandSpec& spec();
};

struct ShowPicture {
    std::size_t picture;
    bool visible;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
