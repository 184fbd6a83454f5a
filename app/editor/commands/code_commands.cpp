#include "app/editor/commands/code_commands.h"

#include <array>
#include <utility>

#include "app/editor/clipboard.h"
#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/finding_rows.h"
#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using exchange::CodeLanguage;

constexpr const char* copy_as_menu = "Copy as";

struct LanguageText {
    CodeLanguage language;
    const char* command;
    const char* title;
    const char* explanation;
};

constexpr std::array<LanguageText, code_language_count> language_texts{
    {{CodeLanguage::json, "copy-as-json", "Copy as JSON", "Copies the active curve as a document of Batten."},
     {CodeLanguage::latex, "copy-as-latex", "Copy as LaTeX",
      "Copies the points and knots of the active curve as a table for LaTeX."},
     {CodeLanguage::tikz, "copy-as-tikz", "Copy as TikZ", "Copies the active curve as a path for TikZ."},
     {CodeLanguage::svg_path, "copy-as-svg-path", "Copy as SVG path",
      "Copies the active curve as the data of a path for SVG, in which y points down."},
     {CodeLanguage::cpp, "copy-as-cpp", "Copy as C++",
      "Copies the active curve as arrays and a function of its points for C++."},
     {CodeLanguage::python, "copy-as-python", "Copy as Python", "Copies the active curve as a BSpline of SciPy."},
     {CodeLanguage::matlab, "copy-as-matlab", "Copy as MATLAB",
      "Copies the active curve as a spline of MATLAB's Curve Fitting Toolbox."}}};

std::string said_of_copy(const EditorState& state, CodeLanguage language, double error) {
    const core::Place as("language", core::title_of(language));
    if (error == 0.0) return core::sentence("Copied curve '{name}' as {language}", {active_name(state), as});
    return core::sentence("Copied curve '{name}' as {language}; no point of it is farther than {error} from the curve",
                          {active_name(state), as, {"error", length_words(units_of(state), error)}});
}

Outcome<void> copy_as(EditorState& state, const CopyAs& command) {
    const auto code = exchange::code_of(*state.history.present().active_curve(), command.language);
    if (!code) return tl::unexpected(Refusal(code.error().sentence()));
    write_clipboard(state, code->text);
    state.message = {said_of_copy(state, command.language, code->error), false};
    return {};
}

template <CodeLanguage language>
Outcome<void> copy_as_language(EditorState& state, const CopyAsLanguage<language>&) {
    return copy_as(state, {language});
}

template <std::size_t index>
CommandSpec copying_as() {
    constexpr LanguageText text = language_texts[index];
    static_assert(text.language == static_cast<CodeLanguage>(index));
    return {.name = text.command,
            .title = text.title,
            .explanation = text.explanation,
            .synonyms = "clipboard code export",
            .group = CommandGroup::edit,
            .submenu = copy_as_menu,
            .offered = in_the_window,
            .refusal = no_curve,
            .run = body_of<copy_as_language<text.language>>};
}

template <std::size_t... index>
std::array<CommandSpec, code_language_count> copying_specs(std::index_sequence<index...>) {
    return {copying_as<index>()...};
}

}  // namespace

const CommandSpec& copy_as_language_spec(CodeLanguage language) {
    static const auto specs = copying_specs(std::make_index_sequence<code_language_count>());
    return specs[static_cast<std::size_t>(language)];
}

const CommandSpec& CopyAs::spec() {
    static const CommandSpec spec{.name = "copy-as",
                                  .title = "Copy as",
                                  .explanation = "Copies the active curve as text for programs and papers.",
                                  .synonyms = "clipboard code export",
                                  .group = CommandGroup::edit,
                                  .offered = {.menu = false, .scripts = false},
                                  .fields = {field::choice<&CopyAs::language>("language", "the language of the text")},
                                  .refusal = no_curve,
                                  .run = body_of<copy_as>};
    return spec;
}

void add_code_commands(CommandTable& table) {
    using enum CodeLanguage;
    add_all<CopyAs, CopyAsLanguage<json>, CopyAsLanguage<latex>, CopyAsLanguage<tikz>, CopyAsLanguage<svg_path>,
            CopyAsLanguage<cpp>, CopyAsLanguage<python>, CopyAsLanguage<matlab>>(table);
}

}  // namespace batten::editor
