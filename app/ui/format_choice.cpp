#include "app/ui/format_choice.h"

#include <imgui.h>

#include <array>
#include <filesystem>

#include "app/editor/words/native_name.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

using core::sentence;
using exchange::Format;

constexpr double format_field_width = 240.0;

bool is_saving_curves(const PanelContext& context) {
    return context.state.dialog == editor::Dialog::save_file;
}

bool is_offered(const exchange::FormatSpec& spec, bool is_saving) {
    return is_saving ? spec.write != nullptr : spec.read != nullptr;
}

// The format of the file: the one that is chosen, else that of the name; none for Batten's own.
std::optional<Format> format_meant(const FileDialogState& dialog) {
    return dialog.format ? dialog.format : exchange::format_of(dialog.choice.typed);
}

bool draws_figure(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    return is_saving_curves(context) && !dialog.format && editor::is_named_as_figure(dialog.choice.typed);
}

std::string text_of_choice(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    if (dialog.format) return sentence("as {format}", {{"format", core::title_of(*dialog.format)}});
    if (draws_figure(context)) return "by its ending: figure";
    const auto format = format_meant(dialog);
    return sentence("by its ending: {format}", {{"format", format ? core::title_of(*format) : "Batten"}});
}

void draw_one(const PanelContext& context, const char* name, const std::string& text, std::optional<Format> format) {
    FileDialogState& dialog = context.panels.file_dialog;
    Button button{sentence("format {name}", {{"name", name}}), text};
    button.width_px = context.px(format_field_width);
    button.anchor = render::Anchor::left;
    button.is_active = dialog.format == format && !draws_figure(context);
    if (!draw_choice(context, button)) return;
    dialog.format = format;
    dialog.takes_focus = true;
}

/// A figure has no format of curves: its name has the ending.
struct FigureChoice {
    const char* name;
    const char* title;
    const char* ending;
};
constexpr std::array figure_choices{FigureChoice{"pdf", "Figure: PDF", ".pdf"},
                                    FigureChoice{"png", "Figure: PNG", ".png"},
                                    FigureChoice{"tikz", "Figure: TikZ for LaTeX", ".tex"}};

void draw_figure_choice(const PanelContext& context, const FigureChoice& choice) {
    FileDialogState& dialog = context.panels.file_dialog;
    std::filesystem::path name = dialog.choice.typed;
    Button button{sentence("format {name}", {{"name", choice.name}}), choice.title};
    button.width_px = context.px(format_field_width);
    button.anchor = render::Anchor::left;
    button.is_active = draws_figure(context) && name.extension() == choice.ending;
    if (!draw_choice(context, button)) return;
    dialog.format.reset();
    dialog.choice.typed = name.empty() ? sentence("figure{ending}", {{"ending", choice.ending}})
                                       : name.replace_extension(choice.ending).string();
    dialog.takes_focus = true;
}

// What happens to curves in the file; nothing is said of Batten's own.
std::string note_on(const PanelContext& context) {
    const bool is_saving = is_saving_curves(context);
    if (draws_figure(context)) return "What the canvas shows is drawn as a figure.";
    const std::optional<Format> format = format_meant(context.panels.file_dialog);
    if (!format) return "";
    const core::Place note("note", exchange::spec_of(*format).note);
    if (is_saving) return sentence("A copy of the visible curves is written: {note}.", {note});
    return sentence("It is read as {format}: {note}.", {{"format", core::title_of(*format)}, note});
}

}  // namespace

bool asks_for_format(editor::Dialog dialog) {
    return dialog == editor::Dialog::open_file || dialog == editor::Dialog::save_file;
}

std::vector<std::string> endings_of_curves(bool is_saving) {
    std::vector<std::string> endings{".json"};
    for (const exchange::FormatSpec& spec : exchange::all_formats()) {
        if (!is_offered(spec, is_saving)) continue;
        endings.insert(endings.end(), spec.endings.begin(), spec.endings.end());
    }
    return endings;
}

void draw_format_choice(const PanelContext& context) {
    ImGui::SetCursorPos({context.px(18), ImGui::GetWindowHeight() - context.px(44)});
    ChoiceField field{"file-dialog format", text_of_choice(context), context.px(format_field_width)};
    field.opens_upward = true;
    if (!begin_choices(context, field)) return;
    draw_one(context, "by-ending", "by its ending", std::nullopt);
    for (const exchange::FormatSpec& spec : exchange::all_formats())
        if (is_offered(spec, is_saving_curves(context)))
            draw_one(context, core::name_of(spec.format), core::title_of(spec.format), spec.format);
    if (is_saving_curves(context))
        for (const FigureChoice& choice : figure_choices) draw_figure_choice(context, choice);
    end_choices();
}

void draw_format_note(const PanelContext& context) {
    const std::string text = note_on(context);
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    report_item(context, "file-dialog note", text);
}

}  // namespace batten::ui
