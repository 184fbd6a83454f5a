/// A color with opacity.
#pragma once

#include <cstdint>

namespace batten::render {

/// sRGB components and straight (not premultiplied) opacity, each 0..255.
struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    bool operator==(const Color&) const = default;
};

/// 0xRRGGBB as an opaque color.
constexpr Color rgb(std::uint32_t hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex),
            255};
}

/// `color` at `opacity` (0..1) times its own.
constexpr Color faded(Color color, double opacity) {
    color.alpha = static_cast<std::uint8_t>(color.alpha * opacity + 0.5);
    return color;
}

/// The opaque color that `color` at `opacity` (0..1) shows over `background`.
constexpr Color blended(Color color, double opacity, Color background) {
    const auto mix = [opacity](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(a * opacity + b * (1.0 - opacity) + 0.5);
    };
    return {mix(color.red, background.red), mix(color.green, background.green), mix(color.blue, background.blue), 255};
}

}  // namespace batten::render
