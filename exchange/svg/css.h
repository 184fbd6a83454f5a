/// Declarations of CSS, as they stand in style attributes and in style sheets.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace batten::exchange {

/// The properties that are looked at. Those from x to d are sizes and places of shapes, which are read as attributes
/// alone; those behind them are looks that curves do not have. The last two are of the font, in whose size lengths can
/// be said.
enum class SvgProperty : std::uint8_t {
    stroke,
    fill,
    visibility,
    display,
    clip_path,
    mask,
    transform,
    transform_origin,
    transform_box,
    translate,
    rotate,
    scale,
    x,
    y,
    width,
    height,
    cx,
    cy,
    r,
    rx,
    ry,
    d,
    stroke_width,
    stroke_dasharray,
    marker,
    marker_start,
    marker_mid,
    marker_end,
    opacity,
    fill_opacity,
    stroke_opacity,
    filter,
    overflow,
    font_size,
    font,
};

inline constexpr std::size_t svg_property_count = static_cast<std::size_t>(SvgProperty::font) + 1;

/// The property of that name; none for those that are not looked at.
std::optional<SvgProperty> svg_property(std::string_view name);

/// What one declaration says, and what it beats: those that are less important, less specific, or before it.
struct CssValue {
    bool is_important = false;
    std::uint16_t specificity = 0;
    std::uint32_t order = 0;
    std::string_view text{};

    bool beats(const CssValue& other) const;
};

/// By property; the text is empty where nothing is said.
using SvgValues = std::array<CssValue, svg_property_count>;

/// Puts `value` into `place` where it beats what is there.
void take(const CssValue& value, CssValue& place);

using CssDeclaration = std::function<void(SvgProperty property, const CssValue& value)>;

/// Hands each declaration of `text` about a property that is looked at to `declaration`, but for sizes of fonts without
/// a unit, which CSS drops; order and specificity are left to it. Cost O(n).
void read_declarations(std::string_view text, const CssDeclaration& declaration);

}  // namespace batten::exchange
