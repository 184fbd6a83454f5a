#include "exchange/dxf/dxf_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/ascii.h"

namespace batten::exchange {

namespace {

using core::PluralPattern;

constexpr PluralPattern widths{"the width of a polyline is left out, of which the middle is read",
                               "the widths of {count} polylines are left out, of which the middles are read"};
constexpr PluralPattern line_types{
    "the line type of a curve is left out, since all curves are drawn as whole lines",
    "the line types of {count} curves are left out, since all curves are drawn as whole lines"};
constexpr PluralPattern line_weights{
    "the line weight of a curve is left out, since all curves are drawn alike but for their colors",
    "the line weights of {count} curves are left out, since all curves are drawn alike but for their colors"};
constexpr PluralPattern thicknesses{"the thickness of a curve, its height above the plane, is left out",
                                    "the thicknesses of {count} curves, their heights above the plane, are left out"};

// The nine colors of the index that are the same everywhere; the seventh is black or white as the paper asks.
std::optional<core::DocumentColor> indexed_color(double index) {
    constexpr std::array<std::array<std::uint8_t, 3>, 6> pure{
        {{255, 0, 0}, {255, 255, 0}, {0, 255, 0}, {0, 255, 255}, {0, 0, 255}, {255, 0, 255}}};
    const double i = std::abs(index);
    if (i == 8.0) return core::DocumentColor{128, 128, 128};
    if (i == 9.0) return core::DocumentColor{192, 192, 192};
    if (!(i >= 1.0 && i <= 6.0)) return std::nullopt;
    const auto& color = pure[static_cast<std::size_t>(i) - 1];
    return core::DocumentColor{color[0], color[1], color[2]};
}

// Of an entity, or of a layer itself, which is on none. An index of another color is one that is not known here.
std::optional<core::DocumentColor> color_of(const DxfEntity& entity, const DxfLook& layer) {
    constexpr double most = 16777215.0;
    constexpr double by_layer = 256.0;
    const double found = entity.number(420, -1.0);
    const double index = entity.number(62, by_layer);
    if (!(found >= 0.0 && found <= most)) return index == by_layer ? layer.color : indexed_color(index);
    const auto color = static_cast<std::uint32_t>(found);
    const auto part = [&](unsigned shift) { return static_cast<std::uint8_t>((color >> shift) & 0xffU); };
    return core::DocumentColor{part(16), part(8), part(0)};
}

// Where an entity does not say it itself, the layer does, if at all.
bool is_dashed(std::string_view line_type, bool of_layer) {
    const std::string name = core::in_small_letters(line_type);
    return name.empty() || name == "bylayer" ? of_layer : name != "continuous" && name != "byblock";
}

bool is_weighty(double line_weight, bool of_layer) {
    constexpr double by_layer = -1.0;
    return line_weight == by_layer ? of_layer : line_weight > 0.0;
}

// Codes of widths are those of a radius in other entities.
bool is_polyline(const DxfEntity& entity) {
    return entity.name() == "LWPOLYLINE" || entity.name() == "POLYLINE";
}

}  // namespace

void DxfLook::tell_losses(Notes& looks) const {
    const auto tell = [&](bool is_lost, const PluralPattern& loss) {
        if (is_lost) looks.add(loss, [] { return std::string(); });
    };
    tell(has_width, widths);
    tell(has_line_type, line_types);
    tell(has_line_weight, line_weights);
    tell(has_thickness, thicknesses);
}

DxfLook look_of_layer(const DxfEntity& layer) {
    constexpr unsigned frozen = 1;
    constexpr unsigned locked = 4;
    DxfLook look = look_of_entity(layer, {});
    look.visible = layer.number(62, 1.0) >= 0.0 && !layer.has_bit(70, frozen);
    look.locked = layer.has_bit(70, locked);
    return look;
}

DxfLook look_of_entity(const DxfEntity& entity, const DxfLook& layer) {
    constexpr double by_layer = -1.0;
    return {.color = color_of(entity, layer),
            .visible = layer.visible && entity.number(60, 0.0) == 0.0,
            .locked = layer.locked,
            .has_line_type = is_dashed(entity.line_type(), layer.has_line_type),
            .has_line_weight = is_weighty(entity.number(370, by_layer), layer.has_line_weight),
            .has_width = is_polyline(entity) && entity.has_widths(),
            .has_thickness = entity.number(39, 0.0) != 0.0};
}

}  // namespace batten::exchange
