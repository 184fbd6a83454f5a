/// Frames as a moving picture, made by ffmpeg where it is installed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "app/cli/figure_order.h"

namespace batten::cli {

/// A folder for frames that only this user can read, which is removed with all that is in it.
class MovieMaker {
  public:
    /// The error is a sentence: ffmpeg is not installed, or there is no room for frames.
    static tl::expected<MovieMaker, std::string> make();

    ~MovieMaker();
    MovieMaker(MovieMaker&& other) noexcept;
    MovieMaker& operator=(MovieMaker&&) = delete;

    /// Takes the next frame, the bytes of a PNG; all have one size. The error is a sentence.
    tl::expected<void, std::string> add(std::string_view png);

    /// The bytes of a file that shows the frames, `rate` in a second. The error is a sentence, with what ffmpeg says.
    tl::expected<std::string, std::string> movie(MovieFormat format, double rate) const;

  private:
    explicit MovieMaker(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;  // empty where it was moved from
    std::size_t count_ = 0;
};

}  // namespace batten::cli
