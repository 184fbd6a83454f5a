#include "render/tex_definitions.h"

#include <fmt/format.h>

#include <array>

#include "render/tex_signs.h"

namespace batten::render {

namespace {

struct Definition {
    std::string_view command;
    std::string_view meaning;  ///< behind its name: how many arguments it has, and what it stands for
};

constexpr std::array definitions{
    Definition{
        "\\battenletters",
        "[1]{?}% Letters for which a stock LaTeX has no font; \\newcommand\\battenletters[1]{#1} before sets them "
        "where there is one."},
    Definition{"\\mathbb", "[1]{\\mathbf{#1}}"},
    Definition{"\\mathscr", "[1]{\\mathcal{#1}}"},
    Definition{"\\bm", R"([1]{\mbox{\boldmath$#1$}})"},
    Definition{"\\boldsymbol", R"([1]{\mbox{\boldmath$#1$}})"},
    Definition{"\\text", "[1]{\\mbox{#1}}"},
    Definition{"\\operatorname", R"([1]{\mathop{\mathrm{#1}}\nolimits})"},
    Definition{"\\tfrac", R"([2]{{\textstyle\frac{#1}{#2}}})"},
    Definition{"\\dfrac", R"([2]{{\displaystyle\frac{#1}{#2}}})"},
    Definition{"\\cfrac", R"([2]{{\displaystyle\frac{#1}{#2}}})"},
    Definition{"\\implies", "{\\Longrightarrow}"},
    Definition{"\\varnothing", "{\\emptyset}"},
    Definition{"\\dotsc", "{\\ldots}"},
    Definition{"\\dotsb", "{\\cdots}"},
    Definition{"\\lvert", "{\\mathopen|}"},
    Definition{"\\rvert", "{\\mathclose|}"},
    Definition{"\\lVert", R"({\mathopen\|})"},
    Definition{"\\rVert", R"({\mathclose\|})"}};

/// Whether `tex` has the command itself, not one whose name is longer.
bool has_command(std::string_view tex, std::string_view command) {
    for (std::size_t at = tex.find(command); at != std::string_view::npos; at = tex.find(command, at + 1)) {
        const std::size_t end = at + command.size();
        if (end == tex.size() || !is_letter(tex[end])) return true;
    }
    return false;
}

}  // namespace

std::string tex_definitions(std::string_view tex) {
    std::string text;
    for (const Definition& definition : definitions)
        if (has_command(tex, definition.command))
            text += fmt::format("\\providecommand{}{}\n", definition.command, definition.meaning);
    return text;
}

}  // namespace batten::render
