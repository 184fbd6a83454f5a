/// The outlines of what is dark in an image.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/progress.h"

namespace batten::core {

/// An image in shades of gray, 0 black to 255 white, row by row from the top.
struct GrayImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> values;  ///< width * height
};

/// A closed polyline; its last point is not its first.
using Contour = std::vector<Point>;

/// The shade midway between what is dark and what is light in the image: between the medians of the two classes that
/// differ most (Otsu 1979). 127.5 for an image of one shade.
double middle_shade(const GrayImage& image);

/// The lines on which the image has the shade `threshold` (0 < threshold < 255), where shades are those of the middles
/// of pixels and linear between them (marching squares; Lorensen and Cline 1987). A pixel is 1 x 1, y runs upward from
/// the lower edge of the image, beyond which all is white. What is darker lies to the left: outlines run
/// counterclockwise, those of holes clockwise. Where dark corners of a cell meet light ones crosswise, the mean of the
/// four decides which of them are connected. Cost O(pixels).
std::vector<Contour> contours(const GrayImage& image, double threshold, const Progress& progress = {});

/// The area that a contour encloses, negative where it runs clockwise.
double area_of(const Contour& contour);

}  // namespace batten::core
