#include "render/image.h"

#include <algorithm>
#include <array>

namespace batten::render {

namespace {

constexpr std::size_t channels = 4;

std::size_t place_of(const Image& image, int x, int y) {
    return channels * (static_cast<std::size_t>(std::min(y, image.height - 1)) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(std::min(x, image.width - 1)));
}

// The mean of the pixels from (x, y), as far as the image has them; what is transparent gives no color.
void append_mean(std::vector<std::uint8_t>& rgba, const Image& image, int x, int y) {
    std::array<unsigned, 3> color{};
    unsigned alpha = 0;
    for (const auto [dx, dy] : {std::array{0, 0}, std::array{1, 0}, std::array{0, 1}, std::array{1, 1}}) {
        const std::uint8_t* pixel = image.rgba.data() + place_of(image, x + dx, y + dy);
        for (std::size_t c = 0; c < color.size(); ++c) color[c] += unsigned{pixel[c]} * pixel[3];
        alpha += pixel[3];
    }
    for (const unsigned sum : color)
        rgba.push_back(static_cast<std::uint8_t>(alpha == 0 ? 0 : (sum + alpha / 2) / alpha));
    rgba.push_back(static_cast<std::uint8_t>((alpha + 2) / 4));
}

}  // namespace

Image halved(const Image& image, int halvings) {
    if (halvings <= 0) return image;
    Image half{(image.width + 1) / 2, (image.height + 1) / 2, {}};
    half.rgba.reserve(channels * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) append_mean(half.rgba, image, 2 * x, 2 * y);
    return halvings == 1 ? half : halved(half, halvings - 1);
}

Image embedded(const Image& image) {
    constexpr int most_side = 4096;
    int halvings = 0;
    while ((std::max(image.width, image.height) - 1) >> halvings >= most_side) ++halvings;
    return halved(image, halvings);
}

}  // namespace batten::render
