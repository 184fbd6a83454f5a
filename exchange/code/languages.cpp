#include "exchange/code/languages.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::exchange {

namespace {

// What would end a comment, or hide in it, is a blank.
std::string in_one_line(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
    return name;
}

template <class Item, class Text>
std::string listed(std::span<const Item> items, std::size_t in_a_line, Text text) {
    std::string result;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) result += i % in_a_line == 0 ? ",\n    " : ", ";
        result += text(items[i]);
    }
    return result;
}

}  // namespace

std::string heading(const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    return core::sentence(curve.is_rational() ? "'{name}': a NURBS curve of degree {degree} over [{lower}, {upper}]"
                                              : "'{name}': a B-spline curve of degree {degree} over [{lower}, {upper}]",
                          {{"name", in_one_line(entry.name)},
                           {"degree", curve.degree()},
                           {"lower", core::shortest_text(curve.domain().lower)},
                           {"upper", core::shortest_text(curve.domain().upper)}});
}

std::string code_number(double value) {
    std::string text;
    core::append_json_text(text, value);
    return text;
}

std::string code_numbers(std::span<const double> values, std::size_t in_a_line) {
    return listed(values, in_a_line, code_number);
}

std::string code_points(std::span<const core::Point> points, const std::function<std::string(core::Point)>& text) {
    return listed(points, 5, text);
}

}  // namespace batten::exchange
