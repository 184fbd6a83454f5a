#include "app/cli/html_text.h"

#include <fmt/format.h>

#include "core/base/sentence.h"
#include "render/label_runs.h"
#include "render/xml_text.h"

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

}  // namespace

std::string html_of_label(std::string_view label) {
    std::string result;
    for (const render::LabelRun& run : render::label_runs(label)) {
        const char* pattern = run.script == render::Script::sub     ? "<sub>{text}</sub>"
                              : run.script == render::Script::super ? "<sup>{text}</sup>"
                                                                    : "{text}";
        result += core::sentence(pattern, {{"text", render::xml_text(run.text)}});
    }
    return result;
}

std::string html_image(std::string_view svg, std::string_view alternative) {
    return core::sentence("<img src='data:image/svg+xml,{data}' alt='{alternative}'>",
                          {{"data", percent_encoded(svg)}, {"alternative", render::xml_text(alternative)}});
}

}  // namespace batten::cli
