#include "exchange/svg/look.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "exchange/svg/losses.h"

namespace batten::exchange {

namespace {

// Changes what `property` is said to be, where it is said: whether it is another value than `plain`.
void take_if_other(const SvgProperties& properties, SvgProperty property, std::initializer_list<std::string_view> plain,
                   bool& is_other) {
    const std::string_view value = properties[property];
    if (value.empty() || value == "inherit") return;
    is_other = std::find(plain.begin(), plain.end(), value) == plain.end();
}

void take_paint(const SvgProperties& properties, SvgProperty property, bool& is_painted, bool& has_pattern) {
    take_if_other(properties, property, {"none", "transparent"}, is_painted);
    const std::string_view value = properties[property];
    if (!value.empty() && value != "inherit") has_pattern = value.starts_with("url(");
}

void take_opacity(const SvgProperties& properties, SvgProperty property, bool& is_clear) {
    take_if_other(properties, property, {"1", "1.0", "100%"}, is_clear);
}

}  // namespace

SvgLook SvgLook::within(const SvgProperties& properties) const {
    SvgLook look = *this;
    take_paint(properties, SvgProperty::fill, look.is_filled, look.has_filling_pattern);
    take_paint(properties, SvgProperty::stroke, look.is_stroked, look.has_stroke_pattern);
    take_if_other(properties, SvgProperty::stroke_width, {"1", "1px"}, look.is_wide);
    take_if_other(properties, SvgProperty::stroke_dasharray, {"none"}, look.is_dashed);
    constexpr std::array markers{SvgProperty::marker_start, SvgProperty::marker_mid, SvgProperty::marker_end};
    for (std::size_t i = 0; i < markers.size(); ++i) {
        take_if_other(properties, SvgProperty::marker, {"none"}, look.has_marker[i]);
        take_if_other(properties, markers[i], {"none"}, look.has_marker[i]);
    }
    take_opacity(properties, SvgProperty::fill_opacity, look.has_clear_filling);
    take_opacity(properties, SvgProperty::stroke_opacity, look.has_clear_stroke);
    bool is_clear = false;
    bool has_filter = false;
    take_opacity(properties, SvgProperty::opacity, is_clear);
    take_if_other(properties, SvgProperty::filter, {"none"}, has_filter);
    look.is_filtered = is_filtered || is_clear || has_filter;
    return look;
}

void SvgLook::tell_losses(std::string_view kind, Notes& notes) const {
    const auto tell = [&](const core::PluralPattern& loss) { notes.add(loss, [] { return std::string(); }); };
    const bool is_area = is_filled && kind != "line";
    if (is_area) tell(svg_loss::fill);
    if (is_stroked && (is_wide || is_dashed)) tell(svg_loss::pen);
    if (std::find(has_marker.begin(), has_marker.end(), true) != has_marker.end()) tell(svg_loss::marker);
    if ((is_area && has_filling_pattern) || (is_stroked && has_stroke_pattern)) tell(svg_loss::pattern);
    if (is_filtered || (is_area && has_clear_filling) || (is_stroked && has_clear_stroke)) tell(svg_loss::opacity);
}

}  // namespace batten::exchange
