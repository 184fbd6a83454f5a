/// How an element is painted beyond what curves have, which is a color.
#pragma once

#include <array>
#include <string_view>

#include "exchange/notes.h"
#include "exchange/svg/style.h"

namespace batten::exchange {

/// What an element hands on to those in it.
struct SvgLook {
    bool is_filled = true;  ///< with black where nothing else is said
    bool is_stroked = false;
    bool is_wide = false;  ///< its line has a width of its own
    bool is_dashed = false;
    std::array<bool, 3> has_marker{};  ///< arrows or the like: at its start, between, at its end
    bool has_filling_pattern = false;  ///< or a gradient
    bool has_stroke_pattern = false;
    bool has_clear_filling = false;  ///< through which one sees
    bool has_clear_stroke = false;
    bool is_filtered = false;  ///< or seen through as a whole, maybe with what is around it

    /// With what an element says itself.
    SvgLook within(const SvgProperties& properties) const;

    /// Notes what the curves of a shape of that kind ("path") lose.
    void tell_losses(std::string_view kind, Notes& notes) const;
};

}  // namespace batten::exchange
