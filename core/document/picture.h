/// A picture that lies below the curves to draw by: where its file is and how it is placed. No export shows it.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/geometry.h"

namespace batten::core {

/// A place in a picture: so many of its pixels to the right and down from its upper left corner.
struct PicturePlace {
    double x = 0.0;
    double y = 0.0;
};

/// A picture of a document. It is a rectangle whose lower left corner is at `position`, turned about that corner.
struct Picture {
    std::filesystem::path path;  ///< absolute in memory, relative to the document in its file
    int width = 0;               ///< pixels, as they were when the picture was added; >= 1
    int height = 0;
    Point position{0.0, 0.0};
    double scale = 1.0;     ///< the size of a pixel in the plane, > 0
    double rotation = 0.0;  ///< degrees, counterclockwise
    double opacity = 0.5;   ///< from 0 to 1
    bool visible = true;
    bool locked = false;
    std::string unknown_members;  ///< members that this version does not know, as a JSON object; empty if none
    bool operator==(const Picture&) const = default;
};

/// Where a place of the picture is in the plane.
Point plane_from_picture(const Picture& picture, PicturePlace place);

/// The place of the picture, or beside it, that is at `point`.
PicturePlace picture_from_plane(const Picture& picture, Point point);

}  // namespace batten::core
