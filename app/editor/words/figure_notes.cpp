#include "app/editor/words/figure_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_listed = 8;
constexpr std::size_t most_counted = 1000;

std::string list_of_first(const std::vector<std::string>& labels) {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < std::min(labels.size(), most_listed); ++k) texts.push_back(plain_text(labels[k]));
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string note_on_labels(const std::vector<std::string>& labels) {
    const char* many = "there was no room for the labels {labels}; a larger figure may have it";
    if (labels.size() > most_listed)
        many = "there was no room for {count} labels, among them {labels}; a larger figure may have it";
    if (labels.size() >= most_counted)
        many = "there was no room for {count} labels or more, among them {labels}; a larger figure may have it";
    return core::sentence(
        {.one = "there was no room for the label {labels}; a larger figure may have it", .many = many}, labels.size(),
        {{"labels", list_of_first(labels)}});
}

std::string note_on_letters(const std::vector<std::string>& letters) {
    return core::sentence(
        "LaTeX as it is installed cannot set {letters}: question marks stand there until the paper "
        "defines \\battenletters",
        {{"letters", list_of_first(letters)}});
}

std::string note_on_boxes(const std::vector<std::string>& letters) {
    return core::sentence(
        "no font of these figures has {letters}: boxes stand there; an SVG figure has them as text, for the fonts of "
        "what shows it",
        {{"letters", list_of_first(letters)}});
}

std::string note_on_commands(const std::vector<std::string>& commands) {
    return core::sentence(
        {.one =
             "{commands} stands in the title as it was typed: these figures set Greek letters, signs such as \\le or "
             "\\int, \\frac, \\sqrt, \\mathbb and \\text; LaTeX sets all commands of a TikZ figure",
         .many =
             "{commands} stand in the title as they were typed: these figures set Greek letters, signs such as \\le "
             "or \\int, \\frac, \\sqrt, \\mathbb and \\text; LaTeX sets all commands of a TikZ figure"},
        commands.size(), {{"commands", list_of_first(commands)}});
}

}  // namespace

std::vector<std::string> figure_notes(const render::FigureLosses& losses) {
    std::vector<std::string> notes;
    if (losses.has_title)
        notes.emplace_back("there was no room for the title; a larger figure or a shorter title has it");
    if (losses.has_legend) notes.emplace_back("there was no room for the legend; a larger figure may have it");
    notes.insert(notes.end(), losses.thinned.begin(), losses.thinned.end());
    if (!losses.labels.empty()) notes.push_back(note_on_labels(losses.labels));
    if (!losses.letters.empty()) notes.push_back(note_on_letters(losses.letters));
    if (!losses.boxes.empty()) notes.push_back(note_on_boxes(losses.boxes));
    if (!losses.commands.empty()) notes.push_back(note_on_commands(losses.commands));
    if (losses.has_images) notes.emplace_back("TikZ has no images, so the pictures are left out");
    return notes;
}

}  // namespace batten::editor
