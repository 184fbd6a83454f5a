#include "exchange/dxf/dxf_entity.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

constexpr int title_code = 2;
constexpr int line_type_code = 6;
constexpr int layer_code = 8;
constexpr int embedded_object_code = 101;
constexpr int bulge_code = 42;

bool is_list(int code) {
    return code == 10 || code == 11 || code == 20 || code == 21 || code == 40 || code == 41;
}

bool is_height(int code) {
    return code == 30 || code == 31 || code == 38;
}

bool is_of_tangent(int code) {
    return code == 12 || code == 13 || code == 22 || code == 23;
}

// A thickness or a line weight, without which a curve runs as it does.
bool is_of_look(int code) {
    return code == 39 || code == 370;
}

std::optional<double> number_of(std::string_view text) {
    const auto number = core::leading_number(text);
    return number && number->length == text.size() ? std::optional(number->value) : std::nullopt;
}

}  // namespace

std::optional<std::size_t> DxfEntity::slot_of(int code) {
    for (std::size_t i = 0; i < kept_codes.size(); ++i)
        if (kept_codes[i] == code) return i;
    return std::nullopt;
}

void DxfEntity::take(const DxfGroup& group) {
    if (has_ended_) return;
    if (group.code == title_code) title_ = group.value;
    if (group.code == line_type_code) line_type_ = group.value;
    if (group.code == layer_code) layer_ = group.value;
    if (group.code == embedded_object_code) has_ended_ = true;
    if (!slot_of(group.code)) return;
    if (const auto number = number_of(group.value)) return keep(group.code, *number);
    if (is_of_look(group.code)) return;
    constexpr std::size_t longest_quotation = 40;
    std::string& defect = is_of_tangent(group.code) ? defect_of_tangents_ : defect_;
    if (defect.empty())
        defect = core::sentence("line {line} has \"{found}\", but it must be a finite number",
                                {{"line", group.line}, {"found", utf8_text(group.value.substr(0, longest_quotation))}});
}

void DxfEntity::keep(int code, double value) {
    std::vector<double>& list = numbers_[*slot_of(code)];
    if (!is_list(code)) list.clear();
    list.push_back(value);
    if (is_height(code) && value != 0.0) is_off_plane_ = true;
    if (code != bulge_code || numbers(10).empty()) return;
    bulges_.resize(numbers(10).size(), 0.0);
    bulges_.back() = value;
}

std::span<const double> DxfEntity::numbers(int code) const {
    return numbers_[*slot_of(code)];
}

double DxfEntity::number(int code, double where_missing) const {
    return numbers(code).empty() ? where_missing : numbers(code).back();
}

bool DxfEntity::has_bit(int code, unsigned bit) const {
    constexpr double most_flags = 65535.0;
    const double flags = std::clamp(number(code, 0.0), 0.0, most_flags);
    return (static_cast<unsigned>(flags) & bit) != 0;
}

std::vector<core::Point> DxfEntity::points(int x_code, int y_code) const {
    const std::span<const double> x = numbers(x_code);
    const std::span<const double> y = numbers(y_code);
    std::vector<core::Point> points(std::min(x.size(), y.size()));
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = {x[i], y[i]};
    return points;
}

std::optional<core::Vector> DxfEntity::vector(int x_code, int y_code) const {
    const core::Vector vector{number(x_code, 0.0), number(y_code, 0.0)};
    const bool is_there = !numbers(x_code).empty() && !numbers(y_code).empty();
    return is_there && vector != core::Vector{0.0, 0.0} ? std::optional(vector) : std::nullopt;
}

bool DxfEntity::has_widths() const {
    const auto is_wide = [](double width) { return width > 0.0; };
    return has_wide_vertex_ || std::ranges::any_of(numbers(40), is_wide) || std::ranges::any_of(numbers(41), is_wide) ||
           is_wide(number(43, 0.0));
}

std::vector<double> DxfEntity::bulges() const {
    std::vector<double> bulges = bulges_;
    bulges.resize(numbers(10).size(), 0.0);
    return bulges;
}

void DxfEntity::forget_vertices() {
    for (const int code : {10, 20, bulge_code}) numbers_[*slot_of(code)].clear();
    bulges_.clear();
}

void DxfEntity::add_vertex(const DxfEntity& vertex) {
    if (!vertex.points(10, 20).empty())
        for (const int code : {10, 20, bulge_code}) keep(code, vertex.number(code, 0.0));
    is_off_plane_ = is_off_plane_ || vertex.is_off_plane_;
    has_wide_vertex_ = has_wide_vertex_ || vertex.has_widths();
    if (defect_.empty()) defect_ = vertex.defect_;
}

}  // namespace batten::exchange
