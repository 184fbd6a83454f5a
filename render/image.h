/// An image of colored pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace batten::render {

/// Rows from the top, each pixel red, green, blue and straight alpha.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes
};

/// The same image with each side halved `halvings` times, rounded up: means of 2 x 2 pixels, weighed by their alpha.
Image halved(const Image& image, int halvings);

/// The image as figures hold it: halved until no side has more than 4096 pixels.
Image embedded(const Image& image);

}  // namespace batten::render
