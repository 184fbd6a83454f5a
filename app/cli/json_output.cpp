#include "app/cli/json_output.h"

#include <fmt/core.h>

#include <cmath>
#include <ostream>
#include <utility>

#include "core/base/number_text.h"

namespace batten::cli {

namespace {

constexpr std::size_t indent = 2;

std::string text_of(const Json& json) {
    return json.dump(static_cast<int>(indent), ' ', false, Json::error_handler_t::replace);
}

// All but the first line are moved to the right.
void print_lines(std::ostream& out, std::string_view text, std::size_t columns) {
    for (const char c : text) {
        out << c;
        if (c == '\n') out << std::string(columns, ' ');
    }
}

}  // namespace

Json json_of(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string point_text(core::Point point) {
    return fmt::format("({}, {})", core::shortest_text(point.x), core::shortest_text(point.y));
}

void print(std::ostream& out, const Json& json) {
    out << text_of(json) << '\n';
}

ListPrinter::ListPrinter(std::ostream& out, const Json& head, std::string_view name, std::size_t columns)
    : out_(out), columns_(columns) {
    constexpr std::string_view end_of_object = "\n}";
    const std::string text = text_of(head);
    print_lines(out, std::string_view(text).substr(0, text.size() - end_of_object.size()), columns);
    out << ',';
    begin_line(columns + indent);
    out << Json(name) << ": [";
}

std::size_t ListPrinter::begin_item() {
    if (!std::exchange(is_empty_, false)) out_ << ',';
    begin_line(columns_ + 2 * indent);
    return columns_ + 2 * indent;
}

void ListPrinter::add(const Json& item) {
    const std::size_t columns = begin_item();
    print_lines(out_, text_of(item), columns);
}

void ListPrinter::end() {
    if (!is_empty_) begin_line(columns_ + indent);
    out_ << ']';
    begin_line(columns_);
    out_ << '}';
}

void ListPrinter::begin_line(std::size_t columns) {
    out_ << '\n' << std::string(columns, ' ');
}

}  // namespace batten::cli
