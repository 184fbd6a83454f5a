#include "exchange/svg/style_sheet.h"

#include <algorithm>
#include <cstddef>

#include "core/base/ascii.h"
#include "core/base/utf8.h"
#include "exchange/svg/drawing.h"
#include "exchange/svg/losses.h"
#include "exchange/svg/scanner.h"

namespace batten::exchange {

namespace {

// More values are left out, so that a file cannot take all memory.
constexpr std::size_t most_sheet_values = 1'000'000;

// The text in `style`, with a blank in place of each comment.
std::string text_of(const pugi::xml_node& style) {
    std::string text;
    for (const pugi::xml_node& part : style.children())
        if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) text += part.value();
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t comment = std::min(text.find("/*", at), text.size());
        kept.append(text, at, comment - at);
        if (comment < text.size()) kept += ' ';
        const std::size_t end = text.find("*/", std::min(comment + 2, text.size()));
        at = end == std::string::npos ? text.size() : end + 2;
    }
    return kept;
}

bool is_css(const pugi::xml_node& style) {
    const std::string_view type = style.attribute("type").value();
    return type.empty() || type == "text/css";
}

// Where the first of `signs` stands outside of quotes and of what is in braces; the end where there is none.
std::size_t find_outside(std::string_view text, std::string_view signs) {
    std::size_t depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (depth == 0 && signs.find(c) != std::string_view::npos) return at;
        if (c == '"' || c == '\'') at = std::min(text.find(c, at + 1), text.size());
        if (c == '{') ++depth;
        if (c == '}' && depth > 0) --depth;
    }
    return text.size();
}

std::string_view taken(std::string_view& text, std::size_t count) {
    const std::string_view front = text.substr(0, count);
    text.remove_prefix(std::min(count + 1, text.size()));
    return front;
}

bool is_name(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return core::is_letter(c) || core::is_digit(c) || c == '-' || c == '_' ||
               static_cast<unsigned char>(c) >= 0x80U;
    });
}

// How much a selector beats others: by ids, classes and names; none where it is not one that is read.
std::optional<std::uint16_t> specificity_of(std::string_view selector) {
    constexpr std::uint16_t of_id = 100;
    constexpr std::uint16_t of_class = 10;
    if (selector == "*") return 0;
    const std::size_t mark = std::min(selector.find_first_of(".#"), selector.size());
    if (mark > 0 && !is_name(selector.substr(0, mark))) return std::nullopt;
    const std::uint16_t of_name = mark > 0 ? 1 : 0;
    if (mark == selector.size()) return mark > 0 ? std::optional(of_name) : std::nullopt;
    if (!is_name(selector.substr(mark + 1))) return std::nullopt;
    return static_cast<std::uint16_t>(of_name + (selector[mark] == '#' ? of_id : of_class));
}

// Whether nothing that is read depends on it.
bool is_harmless(std::string_view rule) {
    return rule.starts_with("@font-face") || rule.starts_with("@charset") || rule.starts_with("@page");
}

// Whether a rule inside of others sets a font.
bool has_font(std::string block) {
    std::ranges::replace_if(
        block, [](char c) { return c == '{' || c == '}'; }, ';');
    bool found = false;
    read_declarations(
        block, [&](SvgProperty property, const CssValue&) { found = found || property >= SvgProperty::font_size; });
    return found;
}

// Whether it is the first one of its property.
bool add_value(std::vector<std::pair<SvgProperty, CssValue>>& values, SvgProperty property, const CssValue& value) {
    const auto known = std::ranges::find(values, property, &std::pair<SvgProperty, CssValue>::first);
    if (known != values.end()) {
        take(value, known->second);
        return false;
    }
    values.emplace_back(property, value);
    return true;
}

// What stands in attributes and in selectors has no limit; it is told shortly.
std::string quoted(std::string_view selector) {
    constexpr std::size_t most_bytes = 60;
    return std::string(core::utf8_front(core::trimmed(selector, svg_blanks), most_bytes));
}

}  // namespace

void StyleSheet::add(const pugi::xml_node& style, Notes& notes) {
    const std::string_view media = core::trimmed(style.attribute("media").value(), svg_blanks);
    if (!is_css(style) || media == "print") return;
    if (!media.empty() && media != "all" && media != "screen") return leave_out_rule(media, text_of(style), notes);
    std::string_view rest = texts_.emplace_back(text_of(style));
    for (rest = core::trimmed(rest, svg_blanks); !rest.empty(); rest = core::trimmed(rest, svg_blanks)) {
        if (rest.starts_with('@')) {
            const std::size_t end = find_outside(rest, ";{");
            const bool has_block = end < rest.size() && rest[end] == '{';
            const std::string_view rule = taken(rest, end);
            const std::string_view block = has_block ? taken(rest, find_outside(rest, "}")) : std::string_view();
            if (!is_harmless(rule)) leave_out_rule(rule, block, notes);
            continue;
        }
        const std::string_view selectors = taken(rest, find_outside(rest, "{"));
        add_rule(selectors, taken(rest, find_outside(rest, "}")), notes);
    }
}

void StyleSheet::leave_out_file(Notes& notes) {
    leaves_out_fonts_ = true;
    notes.add(svg_loss::style_sheet, [] { return std::string(); });
}

void StyleSheet::leave_out_rule(std::string_view rule, std::string_view block, Notes& notes) {
    const bool is_import = rule.starts_with("@import") || block.find("@import") != std::string_view::npos;
    leaves_out_fonts_ = leaves_out_fonts_ || is_import || has_font(std::string(block));
    notes.add(svg_loss::style_rule, [&] { return quoted(rule); });
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view declarations, Notes& notes) {
    SvgValues said{};
    ++rule_count_;
    read_declarations(declarations, [&](SvgProperty property, CssValue value) {
        value.order = rule_count_;
        take(value, said[static_cast<std::size_t>(property)]);
    });
    const auto is_said = [](const CssValue& value) { return !value.text.empty(); };
    auto* const fonts = said.begin() + static_cast<std::ptrdiff_t>(SvgProperty::font_size);
    const bool has_font = std::any_of(fonts, said.end(), is_said);
    const bool has_other = std::any_of(said.begin(), fonts, is_said);
    if (!has_font && !has_other) return;
    while (!selectors.empty()) {
        const std::string_view selector =
            core::trimmed(taken(selectors, std::min(selectors.find(','), selectors.size())), svg_blanks);
        const auto specificity = specificity_of(selector);
        if (!specificity || value_count_ >= most_sheet_values) {
            leaves_out_fonts_ = leaves_out_fonts_ || has_font;
            if (has_other) notes.add(svg_loss::style_rule, [&] { return quoted(selector); });
            continue;
        }
        auto& values = values_[std::string(selector)];
        for (std::size_t i = 0; i < said.size(); ++i) {
            if (said[i].text.empty()) continue;
            CssValue value = said[i];
            value.specificity = *specificity;
            if (add_value(values, static_cast<SvgProperty>(i), value)) ++value_count_;
        }
    }
}

void StyleSheet::read(const pugi::xml_node& element, const CssDeclaration& declaration) const {
    if (values_.empty()) return;
    const std::string name(local_name(element));
    const auto read_for = [&](const std::string& selector) {
        const auto found = values_.find(selector);
        if (found == values_.end()) return;
        for (const auto& [property, value] : found->second) declaration(property, value);
    };
    const auto read_marked = [&](char mark, std::string_view word) {
        const std::string selector = mark + std::string(word);
        read_for(selector);
        read_for(name + selector);
    };
    read_for("*");
    read_for(name);
    if (const std::string_view id = element.attribute("id").value(); !id.empty()) read_marked('#', id);
    std::string_view classes = core::trimmed(element.attribute("class").value(), svg_blanks);
    for (; !classes.empty(); classes = core::trimmed(classes, svg_blanks))
        read_marked('.', taken(classes, std::min(classes.find_first_of(svg_blanks), classes.size())));
}

}  // namespace batten::exchange
