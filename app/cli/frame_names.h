/// Names of the frames of an animation, by a pattern: "frame-%03d.png".
#pragma once

#include <cstddef>
#include <filesystem>

namespace batten::cli {

/// Whether the file's name, not its folder, has one place for a number: %d, or %3d to %09d with a width of one digit,
/// filled up with zeros.
bool has_frame_number(const std::filesystem::path& pattern);

/// The pattern, which has a place, with `number` in it.
std::filesystem::path frame_name(const std::filesystem::path& pattern, std::size_t number);

}  // namespace batten::cli
