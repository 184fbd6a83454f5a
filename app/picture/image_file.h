/// Reads images from files: PNG and JPEG.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "render/image.h"

namespace batten::picture {

/// Images of more pixels are refused: they would take too much memory.
inline constexpr std::size_t most_pixels = 100'000'000;

/// The image in the file at `path`; 16 bits a channel are rounded to 8, gray becomes red, green and blue alike, and the
/// inks of a CMYK file the colors they print. The error is one sentence: there is no such file, it is no PNG or JPEG,
/// it has more pixels than most_pixels, or it is damaged.
[[nodiscard]] tl::expected<render::Image, std::string> read_image(const std::filesystem::path& path);

/// The name of the file may be that of an image: it ends in .png, .jpg or .jpeg, in any case.
[[nodiscard]] bool is_named_as_image(const std::filesystem::path& path);

}  // namespace batten::picture
