#include "app/cli/html_text.h"

#include <fmt/format.h>

#include <optional>

#include "core/base/sentence.h"
#include "render/label_runs.h"

namespace batten::cli {

namespace {

// As a URL has it, but for what is safe in a quoted attribute.
std::string percent_encoded(std::string_view text) {
    constexpr std::string_view plain = " =:/;,.-_()!*@?+~";
    std::string result;
    result.reserve(text.size() + text.size() / 4);
    for (const char c : text) {
        const bool is_word = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
        if (is_word || plain.find(c) != std::string_view::npos)
            result += c;
        else
            fmt::format_to(std::back_inserter(result), "%{:02X}", static_cast<unsigned char>(c));
    }
    return result;
}

/// What stands for a sign that has a meaning of its own.
std::optional<std::string> entity_of(char sign) {
    switch (sign) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        default:
            return std::nullopt;
    }
}

}  // namespace

std::string html_text(std::string_view text) {
    std::string result;
    for (const char c : text) result += entity_of(c).value_or(std::string(1, c));
    return result;
}

std::string html_of_label(std::string_view label) {
    std::string result;
    for (const render::LabelRun& run : render::label_runs(label)) {
        const char* pattern = run.script == render::Script::sub     ? "<sub>{text}</sub>"
                              : run.script == render::Script::super ? "<sup>{text}</sup>"
                                                                    : "{text}";
        result += core::sentence(pattern, {{"text", html_text(run.text)}});
    }
    return result;
}

std::string html_image(std::string_view svg, std::string_view alternative) {
    return core::sentence("<img src='data:image/svg+xml,{data}' alt='{alternative}'>",
                          {{"data", percent_encoded(svg)}, {"alternative", html_text(alternative)}});
}

}  // namespace batten::cli
