#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/commands/dropped_file.h"
#include "app/editor/commands/figure_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/table_commands.h"
#include "app/editor/words/native_name.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/file_rows.h"
#include "app/ui/form_row.h"
#include "app/ui/format_choice.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

namespace fs = std::filesystem;
using core::sentence;

constexpr double dialog_height = 520.0;
constexpr double height_of_fields = 72.0;  // below the list, without the lines of texts there

bool is_saving(const PanelContext& context) {
    return context.state.dialog == editor::Dialog::save_file;
}

/// What the dialog is about, by the editor's dialog.
struct FilePurpose {
    editor::Dialog dialog;
    const char* title;
    const char* accept_label;
    const char* nothing_here;
    std::vector<std::string> endings;  ///< of the files that are listed; empty: of all that have curves
    void (*open)(const PanelContext& context, const fs::path& path);
};

const FilePurpose* purpose_of(editor::Dialog dialog) {
    static const std::array purposes{
        FilePurpose{editor::Dialog::open_file,
                    "Open",
                    "Open",
                    "No folders and no files with curves here.",
                    {},
                    [](const PanelContext& context, const fs::path& path) {
                        if (const auto& format = context.panels.file_dialog.format)
                            context.queue.run(editor::Open{path, format});
                        else
                            context.queue.run(editor::command_for_file(context.state, path, true));
                    }},
        FilePurpose{
            editor::Dialog::save_file, "Save as", "Save", "No folders and no files with curves here.", {}, nullptr},
        FilePurpose{editor::Dialog::open_table,
                    "Open table",
                    "Open",
                    "No folders and no tables (.csv, .dat, .tsv, .txt) here.",
                    {".csv", ".dat", ".tsv", ".txt"},
                    [](const PanelContext& context, const fs::path& path) {
                        context.queue.run(editor::OpenTable{.path = path});
                    }},
        FilePurpose{editor::Dialog::open_picture,
                    "Add picture",
                    "Add",
                    "No folders and no pictures (.png, .jpg, .jpeg) here.",
                    {".png", ".jpg", ".jpeg"},
                    [](const PanelContext& context, const fs::path& path) {
                        context.queue.run(editor::CloseDialog{});
                        context.queue.run(editor::picture_in_view(context.state, path));
                    }}};
    for (const FilePurpose& purpose : purposes)
        if (purpose.dialog == dialog) return &purpose;
    return nullptr;
}

/// Where the dialog begins: beside the file that is open, else beside the last one, else where the program was started.
fs::path first_folder(const editor::EditorState& state) {
    for (const fs::path& file : {state.path, state.source})
        if (!file.empty()) return file.parent_path();
    if (!state.recent_files.empty()) return state.recent_files.front().parent_path();
    std::error_code error;
    return fs::current_path(error);
}

std::string suggested_name(const editor::EditorState& state) {
    if (!state.path.empty()) return state.path.filename().string();
    return state.source.empty() ? "untitled.json" : state.source.filename().replace_extension(".json").string();
}

void show_folder(FileDialogState& dialog, const fs::path& folder) {
    dialog.problem = enter_folder(dialog.choice, folder, dialog.suggested_name);
    dialog.takes_focus = dialog.shows_choice = dialog.follows_choice = true;
}

void begin_choice(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    dialog = {};
    dialog.was_open = true;
    dialog.choice.endings = purpose_of(context.state.dialog)->endings;
    if (dialog.choice.endings.empty()) dialog.choice.endings = endings_of_curves(is_saving(context));
    if (is_saving(context)) dialog.suggested_name = suggested_name(context.state);
    show_folder(dialog, first_folder(context.state));
    // The folder may be gone.
    if (dialog.choice.folder.empty()) show_folder(dialog, "/");
    // An older sentence would look as if it were about this dialog.
    if (context.state.message.is_error) context.queue.run(editor::DismissMessage{});
}

/// Curves or, where that was chosen, a figure.
void write_file(const PanelContext& context, const fs::path& path) {
    if (draws_figure(context))
        context.queue.run(editor::ExportFigure{.path = path, .replace = true});
    else
        context.queue.run(editor::SaveAs{path, context.panels.file_dialog.format});
}

void save_as(const PanelContext& context, const fs::path& typed) {
    FileDialogState& dialog = context.panels.file_dialog;
    const editor::Outcome<editor::SavedName> name = editor::saved_name(typed, dialog.format);
    std::error_code error;
    if (name && fs::exists(name->path, error) && name->path != context.state.path) {
        dialog.to_replace = name->path;
        dialog.is_replacing = false;
    } else {
        write_file(context, typed);
    }
}

/// Goes on with what is typed, or with what is chosen where there is no such file to open: into a folder, or with a
/// file.
void accept(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    dialog.takes_focus = dialog.shows_choice = true;
    if (dialog.choice.typed.empty()) return;
    fs::path path = meant_path(dialog.choice.folder, dialog.choice.typed);
    std::error_code error;
    if (!is_saving(context) && !fs::exists(path, error)) path = chosen_path(dialog.choice).value_or(path);
    if (fs::is_directory(path, error)) {
        show_folder(dialog, path);
    } else if (is_saving(context)) {
        save_as(context, path);
    } else {
        purpose_of(context.state.dialog)->open(context, path);
    }
}

/// The end of a long path, "…/lectures/week 3", which says more than its beginning.
std::string end_of_path(const std::string& path, ImFont* font, float width_px) {
    std::string shown = path;
    std::size_t slash = path.find('/', 1);
    while (slash != std::string::npos && text_width(shown, font) > width_px) {
        shown = fmt::format("…{}", path.substr(slash));
        slash = path.find('/', slash + 1);
    }
    return shown;
}

void draw_folder_row(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    const fs::path shown = dialog.choice.listed.folder;
    if (draw_label_button(context, "file-dialog up", "↑")) show_folder(dialog, shown.parent_path());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + context.px(2));
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(end_of_path(shown.string(), context.fonts.text, room).c_str());
    report_item(context, "file-dialog folder", shown.string());
}

const char* reason_of_no_rows(const PanelContext& context) {
    const FolderContent& listed = context.panels.file_dialog.choice.listed;
    if (listed.is_missing) return "There is no such folder.";
    if (!listed.problem.empty()) return "This folder cannot be read.";
    if (listed.entries.empty()) return purpose_of(context.state.dialog)->nothing_here;
    return "Nothing here has that in its name.";
}

/// How many rows Page Up and Page Down move.
std::ptrdiff_t page_of(float height_px, float pitch_px) {
    return std::max<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(height_px / pitch_px) - 1, 1);
}

/// The keys that move the choice while the name is the active field. Home and End belong to the text until the others
/// have led into the list.
std::ptrdiff_t rows_of_keys(const PanelContext& context, std::ptrdiff_t page) {
    const auto all = static_cast<std::ptrdiff_t>(context.panels.file_dialog.choice.shown.size());
    std::ptrdiff_t rows = 0;
    if (was_pressed(context, editor::Key::down)) rows += 1;
    if (was_pressed(context, editor::Key::up)) rows -= 1;
    if (was_pressed(context, editor::Key::page_down)) rows += page;
    if (was_pressed(context, editor::Key::page_up)) rows -= page;
    if (!context.panels.file_dialog.choice.is_led_by_keys) return rows;
    if (was_pressed(context, editor::Key::end)) rows += all;
    if (was_pressed(context, editor::Key::home)) rows -= all;
    return rows;
}

void move_by_keys(const PanelContext& context, std::ptrdiff_t page) {
    FileDialogState& dialog = context.panels.file_dialog;
    const std::ptrdiff_t rows = dialog.to_replace ? 0 : rows_of_keys(context, page);
    if (rows == 0) return;
    move_choice(dialog.choice, rows);
    dialog.shows_choice = dialog.follows_choice = true;
}

void take_click(const PanelContext& context, std::size_t row) {
    FileDialogState& dialog = context.panels.file_dialog;
    choose(dialog.choice, row);
    dialog.to_replace.reset();
    dialog.takes_focus = dialog.shows_choice = true;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) accept(context);
}

void draw_entries(const PanelContext& context, float height_px) {
    FileDialogState& dialog = context.panels.file_dialog;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imgui_color(context.theme.canvas));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(6), context.px(6)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(8), context.px(6)));
    ImGui::BeginChild("entries", ImVec2(0.0F, height_px), true, ImGuiWindowFlags_NoNav);
    const float pitch = ImGui::GetTextLineHeightWithSpacing();
    move_by_keys(context, page_of(ImGui::GetContentRegionAvail().y, pitch));
    scroll_to_choice(dialog, pitch);
    const std::optional<std::size_t> clicked = draw_file_rows(context, pitch);
    if (dialog.choice.shown.empty()) ImGui::TextDisabled("%s", reason_of_no_rows(context));
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
    if (clicked) take_click(context, *clicked);
}

/// Puts the text that the dialog itself wrote into the active field, selected, so that typing begins anew.
int follow_choice(ImGuiInputTextCallbackData* data) {
    auto& dialog = *static_cast<FileDialogState*>(data->UserData);
    if (!std::exchange(dialog.shows_choice, false)) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, dialog.choice.typed.c_str());
    data->SelectAll();
    return 0;
}

void draw_name_field(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    const bool is_asking = dialog.to_replace.has_value();
    if (!is_asking && std::exchange(dialog.takes_focus, false)) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(10), context.px(7)));
    ImGui::SetNextItemWidth(-1.0F);
    const bool was_typed = !dialog.shows_choice;
    const std::string before = dialog.choice.typed;
    ImGui::BeginDisabled(is_asking);
    ImGui::InputTextWithHint("##name", "Name, or the whole path of a file", &dialog.choice.typed,
                             ImGuiInputTextFlags_CallbackAlways, follow_choice, &dialog);
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
    report_item(context, "file-dialog name", dialog.choice.typed);
    if (!was_typed || dialog.choice.typed == before) return;
    follow_typed(dialog.choice, !is_saving(context));
    dialog.problem.clear();
    dialog.follows_choice = true;
}

/// What is wrong, if anything is.
std::string problem_of_files(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    if (context.state.message.is_error) return context.state.message.text;
    return dialog.problem.empty() ? dialog.choice.listed.problem : dialog.problem;
}

const char* question_about(const editor::EditorState& state, const fs::path& file) {
    std::error_code error;
    const bool is_source = !state.source.empty() && fs::equivalent(file, state.source, error);
    return is_source && state.source_has_more ? "Replace {name}? What was left out when it was opened is lost then."
                                              : "Replace {name}? It exists already.";
}

/// What stands below the name: the question, what is wrong, or what the format does.
void draw_sentence(const PanelContext& context) {
    const FileDialogState& dialog = context.panels.file_dialog;
    if (dialog.to_replace) {
        const float room = ImGui::GetContentRegionAvail().x;
        const std::string name = elided(dialog.to_replace->filename().string(), context.fonts.text, room);
        const std::string question = sentence(question_about(context.state, *dialog.to_replace), {{"name", name}});
        ImGui::TextWrapped("%s", question.c_str());
        report_item(context, "dialog question", question);
        show_cut_text(context, dialog.to_replace->string(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    } else if (const std::string problem = problem_of_files(context); !problem.empty()) {
        draw_dialog_error(context, problem);
    } else {
        draw_format_note(context);
    }
}

/// Of that sentence: two lines, or as many as it needs where the window is so low that the list needs the rest.
float sentence_height_px(const PanelContext& context) {
    const std::string problem = problem_of_files(context);
    // As wide as with the sign of an error.
    const std::string text = problem.empty() ? format_note(context) : fmt::format("⚠ {}", problem);
    const float needed =
        text.empty() ? 0.0F : wrapped_height_px(text, context.fonts.text, ImGui::GetContentRegionAvail().x);
    const bool is_low = ImGui::GetWindowHeight() < context.px(dialog_height);
    const float line = ImGui::GetTextLineHeight();
    if (context.panels.file_dialog.to_replace) return is_low ? line : 2.0F * line;
    return is_low ? needed : std::max(needed, 2.0F * line);
}

void place_buttons(const PanelContext& context, const char* first, const char* second) {
    const float width =
        label_button_width(context, first) + label_button_width(context, second) + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPos({ImGui::GetWindowWidth() - width - context.px(18), ImGui::GetWindowHeight() - context.px(46)});
}

/// Tab and the arrow keys choose an answer, Enter and Space give it; at first that is to keep the file, so that a
/// second Enter overwrites nothing.
bool is_answered_by_keys(const PanelContext& context) {
    bool& is_replacing = context.panels.file_dialog.is_replacing;
    if (was_pressed(context, editor::Key::tab) || was_pressed(context, editor::Key::tab, {.shift = true}))
        is_replacing = !is_replacing;
    if (was_pressed(context, editor::Key::left)) is_replacing = false;
    if (was_pressed(context, editor::Key::right)) is_replacing = true;
    return was_pressed(context, editor::Key::enter) || was_pressed(context, editor::Key::space);
}

/// The answers to whether the file that is there may be replaced.
void draw_question(const PanelContext& context, bool is_left) {
    FileDialogState& dialog = context.panels.file_dialog;
    const bool is_answered = is_answered_by_keys(context);
    const auto look_of = [](bool is_chosen) { return is_chosen ? ButtonLook::primary : ButtonLook::plain; };
    place_buttons(context, "Keep", "Replace");
    const bool is_kept = draw_label_button(context, "dialog keep", "Keep", look_of(!dialog.is_replacing));
    ImGui::SameLine();
    const bool is_replaced = draw_label_button(context, "dialog replace", "Replace", look_of(dialog.is_replacing));
    if (is_replaced || (is_answered && dialog.is_replacing)) write_file(context, *dialog.to_replace);
    if (!is_replaced && !is_kept && !is_left && !is_answered) return;
    dialog.to_replace.reset();
    dialog.takes_focus = dialog.shows_choice = true;
}

void draw_answers(const PanelContext& context, bool is_left) {
    const char* accept_label = purpose_of(context.state.dialog)->accept_label;
    place_buttons(context, "Cancel", accept_label);
    if (draw_label_button(context, "dialog cancel", "Cancel") || is_left) context.queue.run(editor::CloseDialog{});
    ImGui::SameLine();
    const bool is_accepted = draw_label_button(context, is_saving(context) ? "dialog save" : "dialog open",
                                               accept_label, ButtonLook::primary);
    if (is_accepted || was_pressed(context, editor::Key::enter)) accept(context);
}

}  // namespace

void draw_file_dialog(const PanelContext& context, const Rectangle& window) {
    FileDialogState& dialog = context.panels.file_dialog;
    const FilePurpose* purpose = purpose_of(context.state.dialog);
    if (purpose == nullptr) {
        dialog.was_open = false;
        return;
    }
    if (!dialog.was_open) begin_choice(context);
    DialogFrame frame;
    frame.title = purpose->title;
    frame.size = {640.0, dialog_height};
    frame.closes_on_outside = false;
    const bool is_left = begin_dialog(context, window, frame) && !dialog.lists_formats;
    draw_folder_row(context);
    draw_entries(context, -context.px(height_of_fields) - ImGui::GetTextLineHeight() - sentence_height_px(context));
    draw_name_field(context);
    draw_sentence(context);
    if (dialog.to_replace) {
        draw_question(context, is_left);
    } else {
        if (asks_for_format(context.state.dialog)) draw_format_choice(context);
        draw_answers(context, is_left);
    }
    end_dialog();
}

}  // namespace batten::ui
