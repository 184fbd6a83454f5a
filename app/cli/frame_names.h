/// Names of the frames of an animation, by a pattern: "frame-%03d.png".
#pragma once

#include <cstddef>
#include <filesystem>

namespace batten::cli {

/// How many places for a number the file's name, not its folder, has: %d, or %3d to %09d with a width of one digit,
/// filled up with zeros. %% is a percent sign.
std::size_t frame_number_count(const std::filesystem::path& pattern);

/// The pattern with `number` in its place.
std::filesystem::path frame_name(const std::filesystem::path& pattern, std::size_t number);

}  // namespace batten::cli
