#include "app/ui/format_choice.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/editor/words/native_name.h"
#include "app/ui/dialog_frame.h"
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

/// The ending that says so, where it is also that of curves.
bool draws_svg(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    return dialog.draws_svg && exchange::format_of(dialog.choice.typed) == Format::svg;
}

/// Whether the name says nothing that could be written.
bool is_unknown(const PanelContext& context) {
    const std::string& typed = context.panels.file_dialog.choice.typed;
    return is_saving_curves(context) && !format_meant(context.panels.file_dialog) && !draws_figure(context) &&
           editor::foreign_ending(typed);
}

std::string text_of_choice(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    if (dialog.format) return sentence("as {format}", {{"format", core::title_of(*dialog.format)}});
    if (draws_svg(context)) return "as figure";
    if (draws_figure(context)) return "by its ending: figure";
    if (is_unknown(context)) return "by its ending: unknown";
    const auto format = format_meant(dialog);
    return sentence("by its ending: {format}", {{"format", format ? core::title_of(*format) : "Batten"}});
}

/// One of the list; returns whether it was chosen.
bool draw_entry(const PanelContext& context, const char* name, const char* title, bool is_active) {
    FileDialogState& dialog = context.panels.file_dialog;
    Button button{sentence("format {name}", {{"name", name}}), title};
    button.width_px = context.px(format_field_width);
    button.anchor = render::Anchor::left;
    button.is_active = is_active;
    if (!draw_choice(context, button)) return false;
    dialog.format.reset();
    dialog.draws_svg = false;
    dialog.takes_focus = true;
    return true;
}

/// What is chosen by the ending that the name is given: figures, which have no format of curves, and Batten's own.
struct EndingChoice {
    const char* name;
    const char* title;
    std::string_view ending;
};
constexpr EndingChoice native_choice{"batten", "Batten", ".json"};
constexpr EndingChoice svg_figure_choice{"figure-svg", "Figure: SVG", ".svg"};
constexpr std::array figure_choices{svg_figure_choice, EndingChoice{"pdf", "Figure: PDF", ".pdf"},
                                    EndingChoice{"png", "Figure: PNG", ".png"},
                                    EndingChoice{"tikz", "Figure: TikZ for LaTeX", ".tex"}};

bool is_named_natively(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    const std::filesystem::path name = dialog.choice.typed;
    return is_saving_curves(context) && !format_meant(dialog) && name.extension() == native_choice.ending;
}

/// "wave.svg" for "wave", "wave.pdf" and "wave.tinyspline.json".
std::string with_ending(const std::string& typed, std::string_view ending) {
    std::filesystem::path name = typed.empty() ? "untitled" : typed;
    const bool has_ending = exchange::format_of(name) || editor::is_named_as_figure(name) ||
                            editor::foreign_ending(name) || name.extension() == native_choice.ending;
    if (has_ending) name.replace_extension();
    if (exchange::format_of(sentence("{name}.json", {{"name", name.string()}}))) name.replace_extension();
    return (name += ending).string();
}

void draw_format(const PanelContext& context, const char* name, const char* title, std::optional<Format> format) {
    FileDialogState& dialog = context.panels.file_dialog;
    const bool is_active = dialog.format == format && !draws_figure(context) && !is_named_natively(context);
    if (draw_entry(context, name, title, is_active)) dialog.format = format;
}

void draw_ending(const PanelContext& context, const EndingChoice& choice, bool is_active) {
    FileDialogState& dialog = context.panels.file_dialog;
    if (!draw_entry(context, choice.name, choice.title, is_active)) return;
    dialog.choice.typed = with_ending(dialog.choice.typed, choice.ending);
    dialog.draws_svg = choice.ending == svg_figure_choice.ending;
}

void draw_figures(const PanelContext& context) {
    const std::filesystem::path name = context.panels.file_dialog.choice.typed;
    for (const EndingChoice& choice : figure_choices)
        draw_ending(context, choice, draws_figure(context) && name.extension() == choice.ending);
}

}  // namespace

bool asks_for_format(editor::Dialog dialog) {
    return dialog == editor::Dialog::open_file || dialog == editor::Dialog::save_file;
}

bool draws_figure(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    if (!is_saving_curves(context) || dialog.format) return false;
    return editor::is_named_as_figure(dialog.choice.typed) || draws_svg(context);
}

std::string format_note(const PanelContext& context) {
    if (!asks_for_format(context.state.dialog)) return "";
    const bool is_saving = is_saving_curves(context);
    if (draws_figure(context)) return "What the canvas shows is drawn as a figure.";
    const std::optional<Format> format = format_meant(context.panels.file_dialog);
    if (!format) return "";
    const core::Place note("note", exchange::spec_of(*format).note);
    if (is_saving) return sentence("A copy of the visible curves is written: {note}.", {note});
    return sentence("It is read as {format}: {note}.", {{"format", core::title_of(*format)}, note});
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
    // The title stays in sight, which says what is done.
    field.top_px = ImGui::GetWindowPos().y + dialog_head_px(context) - dialog_padding_px(context);
    FileDialogState& dialog = context.panels.file_dialog;
    const bool was_open = std::exchange(dialog.lists_formats, begin_choices(context, field));
    if (was_open && !dialog.lists_formats) dialog.takes_focus = true;
    if (!dialog.lists_formats) return;
    draw_format(context, "by-ending", "by its ending", std::nullopt);
    if (is_saving_curves(context)) draw_ending(context, native_choice, is_named_natively(context));
    for (const exchange::FormatSpec& spec : exchange::all_formats())
        if (is_offered(spec, is_saving_curves(context)))
            draw_format(context, core::name_of(spec.format), core::title_of(spec.format), spec.format);
    if (is_saving_curves(context)) draw_figures(context);
    end_choices();
}

void draw_format_note(const PanelContext& context) {
    const std::string text = format_note(context);
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    report_item(context, "file-dialog note", text);
}

}  // namespace batten::ui
