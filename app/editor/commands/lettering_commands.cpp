#include "app/editor/commands/lettering_commands.h"

#include "app/editor/commands/added_curves.h"
#include "app/editor/commands/file_acts.h"
#include "app/editor/commands/joint_report.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "core/base/sentence.h"
#include "core/document/file_text.h"
#include "exchange/font_reader.h"

namespace batten::editor {

namespace {

namespace fs = std::filesystem;

Refusal font_refusal(const fs::path& path, const std::string& what) {
    return core::sentence("{file}: {what}", {{"file", path.filename().string()}, {"what", what}});
}

Outcome<Edit> add_text_outlines(const EditorState& state, const TextOutlines& command) {
    const fs::path path = absolute_path(command.path);
    std::error_code error;
    // A pipe would keep the window waiting.
    if (fs::exists(path, error) && !fs::is_regular_file(path, error))
        return tl::unexpected(font_refusal(path, "this is not an ordinary file; a font is needed"));
    const core::FileResult<std::string> font = core::read_bytes(path);
    if (!font) return tl::unexpected(font_refusal(path, font.error().what));
    const core::FileResult<exchange::Imported> letters =
        exchange::read_glyphs(*font, {.text = command.text, .position = command.position, .size = command.size});
    if (!letters) return tl::unexpected(font_refusal(path, letters.error().sentence()));
    Edit edit{state.history.present(), Selection{}};
    edit.document.active = edit.document.curves.size();
    add_curves(edit.document, letters->document.curves);
    edit.remark = told_in_turn(letters->report.left_out);
    return edit;
}

core::Point middle_for_text(const EditorState& state) {
    return suggest::middle_of_view(state);
}

double size_for_text(const EditorState& state) {
    constexpr double steps = 10.0;
    return steps * suggest::grid_step(state);
}

}  // namespace

const CommandSpec& TextOutlines::spec() {
    static const CommandSpec spec{
        .name = "text-outlines",
        .title = "Outlines of a text",
        .explanation = "Adds the outlines of letters in a font file, TrueType or PostScript, as closed curves.",
        .synonyms = "font glyph letters write truetype opentype",
        .group = CommandGroup::make,
        .fields = {field::file<&TextOutlines::path>("path", "the font file"),
                   field::text<&TextOutlines::text>("text", "what is written"),
                   field::position<&TextOutlines::position>({"x", "x of the left end of its base line"},
                                                            {"y", "y of the left end of its base line"})
                       .suggesting<middle_for_text>(),
                   field::length<&TextOutlines::size>("size", "of the em, which is about the height of a line, above 0")
                       .above(0.0)
                       .suggesting<size_for_text>()},
        .run = body_of<add_text_outlines>,
        .at_work = "Reading {path}",
        .step = "Make outlines of a text",
        .done = "Made outlines of '{text}'"};
    return spec;
}

}  // namespace batten::editor
