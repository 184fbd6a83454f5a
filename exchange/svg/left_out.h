/// What of an SVG file does not become curves, counted while it is read.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace batten::exchange {

/// The reasons, in the order in which they are told.
enum class SvgLoss {
    wrong_path,       ///< data that go wrong, with the name and the place
    refused_curve,    ///< a curve that cannot be, with the name and the reason
    wrong_transform,  ///< with the name
    text,
    image,
    foreign,
    not_displayed,
    for_others,   ///< for other languages, or programs with extensions
    outside,      ///< an element of another file
    unknown_use,  ///< a use of what is not there
    circle,       ///< a use of itself, or too deep
    clipped,      ///< clip paths, masks
    style_sheet,
    entities,
    too_deep,
    too_many,
    too_often,  ///< repeated by uses
};
inline constexpr std::size_t svg_loss_count = static_cast<std::size_t>(SvgLoss::too_often) + 1;

class LeftOut {
  public:
    /// One more; the first one of a kind is the one that is named.
    void count(SvgLoss loss, const std::string& name = {}, const std::string& detail = {});

    bool is_empty() const;

    /// One sentence for each kind.
    std::vector<std::string> sentences() const;

  private:
    struct Kind {
        std::size_t count = 0;
        std::string name{};
        std::string detail{};
    };
    std::array<Kind, svg_loss_count> kinds_{};
};

}  // namespace batten::exchange
