#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/native_name.h"
#include "app/ui/dialog_frame.h"
#include "app/ui/folder_list.h"
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

bool is_saving(const PanelContext& context) {
    return context.state.dialog == editor::Dialog::save_file;
}

/// Where the dialog begins: beside the file that is open, else beside the last one, else where the program was started.
fs::path first_folder(const editor::EditorState& state) {
    if (!state.path.empty()) return state.path.parent_path();
    if (!state.recent_files.empty()) return state.recent_files.front().parent_path();
    std::error_code error;
    return fs::current_path(error);
}

void enter_folder(FileDialogState& dialog, const fs::path& folder) {
    FolderContent content = read_folder(folder);
    dialog.problem = content.problem;
    if (!content.problem.empty()) return;
    dialog.folder = content.folder;
    dialog.entries = std::move(content.entries);
    dialog.chosen.reset();
}

void begin_choice(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    dialog = {};
    dialog.was_open = true;
    dialog.takes_focus = true;
    enter_folder(dialog, first_folder(context.state));
    if (is_saving(context)) {
        const fs::path& path = context.state.path;
        dialog.typed = path.empty() ? "untitled.json" : path.filename().string();
    }
    // An older sentence would look as if it were about this dialog.
    if (context.state.message.is_error) context.queue.run(editor::DismissMessage{});
}

/// The path that is meant by what was typed or pasted: absolute, from the home folder, or from the folder shown.
fs::path meant_path(const FileDialogState& dialog) {
    const std::string& typed = dialog.typed;
    if (typed.rfind("~/", 0) == 0) {
        const char* home = std::getenv("HOME");
        if (home != nullptr) return fs::path(home) / typed.substr(2);
    }
    return dialog.folder / typed;
}

void save_as(const PanelContext& context, const fs::path& typed) {
    const editor::Outcome<fs::path> path = editor::native_path(typed);
    std::error_code error;
    if (path && fs::exists(*path, error) && *path != context.state.path) {
        context.panels.file_dialog.to_replace = *path;
    } else {
        context.queue.run(editor::SaveAs{.path = typed});
    }
}

/// Goes on with what is typed: into a folder, or with a file.
void accept(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    if (dialog.typed.empty()) return;
    const fs::path path = meant_path(dialog);
    std::error_code error;
    if (fs::is_directory(path, error)) {
        enter_folder(dialog, path);
        dialog.typed.clear();
        dialog.takes_focus = true;
    } else if (is_saving(context)) {
        save_as(context, path);
    } else {
        context.queue.run(editor::Open{.path = path});
        dialog.takes_focus = true;
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
    if (draw_label_button(context, "file-dialog up", "↑")) enter_folder(dialog, dialog.folder.parent_path());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + context.px(2));
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(end_of_path(dialog.folder.string(), context.fonts.text, room).c_str());
    report_item(context, "file-dialog folder", dialog.folder.string());
}

void draw_entry_row(const PanelContext& context, std::size_t index) {
    FileDialogState& dialog = context.panels.file_dialog;
    const fs::directory_entry& entry = dialog.entries[index];
    std::error_code error;
    const bool is_folder = entry.is_directory(error);
    const std::string name = entry.path().filename().string();
    const std::string shown = is_folder ? fmt::format("{}/", name) : name;
    ImGui::PushID(name.c_str());
    if (is_folder) ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(context.theme.dim));
    const bool is_clicked = ImGui::Selectable("##entry", dialog.chosen == index, ImGuiSelectableFlags_AllowDoubleClick);
    const Rectangle place = last_item_place();
    report_item(context, fmt::format("{} {}", is_folder ? "folder" : "file", name));
    const glm::vec2 corner(place.origin_px);
    ImGui::GetWindowDrawList()->AddText({corner.x + context.px(10), corner.y + 0.5F * ImGui::GetStyle().ItemSpacing.y},
                                        ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
    if (is_folder) ImGui::PopStyleColor();
    ImGui::PopID();
    if (!is_clicked) return;
    dialog.chosen = index;
    dialog.typed = name;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) accept(context);
}

/// Up and Down choose from the list while the name is the active field.
void move_choice(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    const int step =
        (was_pressed(context, editor::Key::down) ? 1 : 0) - (was_pressed(context, editor::Key::up) ? 1 : 0);
    if (step == 0 || dialog.entries.empty()) return;
    const auto last = static_cast<std::ptrdiff_t>(dialog.entries.size()) - 1;
    const std::ptrdiff_t before =
        dialog.chosen ? static_cast<std::ptrdiff_t>(*dialog.chosen) : (step > 0 ? -1 : last + 1);
    dialog.chosen = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(before + step, 0, last));
    dialog.typed = dialog.entries[*dialog.chosen].path().filename().string();
    dialog.takes_focus = true;
}

void draw_entries(const PanelContext& context, float height_px) {
    FileDialogState& dialog = context.panels.file_dialog;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imgui_color(context.theme.canvas));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(context.px(6), context.px(6)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(8), context.px(6)));
    ImGui::BeginChild("entries", ImVec2(0.0F, height_px), true, ImGuiWindowFlags_NoNav);
    // Entering a folder replaces the list, so the count is asked for anew.
    for (std::size_t i = 0; i < dialog.entries.size(); ++i) draw_entry_row(context, i);
    if (dialog.entries.empty()) ImGui::TextDisabled("No folders and no .json files here.");
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor();
}

/// Dear ImGui selects the text only when the field becomes active for the first time.
int select_all(ImGuiInputTextCallbackData* data) {
    auto& dialog = *static_cast<FileDialogState*>(data->UserData);
    if (std::exchange(dialog.selects_all, false)) data->SelectAll();
    return 0;
}

void draw_name_field(const PanelContext& context) {
    FileDialogState& dialog = context.panels.file_dialog;
    if (std::exchange(dialog.takes_focus, false)) {
        ImGui::SetKeyboardFocusHere();
        dialog.selects_all = true;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(10), context.px(7)));
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##name", "Name, or the whole path of a file", &dialog.typed,
                             ImGuiInputTextFlags_CallbackAlways, select_all, &dialog);
    ImGui::PopStyleVar();
    report_item(context, "file-dialog name", dialog.typed);
}

void draw_problem(const PanelContext& context) {
    const editor::Message& message = context.state.message;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = 2.0F * ImGui::GetTextLineHeight();
    draw_dialog_error(context, message.is_error ? message.text : context.panels.file_dialog.problem);
    ImGui::SetCursorScreenPos({corner.x, corner.y + height + context.px(6)});
}

void place_buttons(const PanelContext& context, const char* first, const char* second) {
    const float width =
        label_button_width(context, first) + label_button_width(context, second) + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPos({ImGui::GetWindowWidth() - width - context.px(18), ImGui::GetWindowHeight() - context.px(46)});
}

/// Asks whether the file that is there may be replaced; returns whether the question is still open.
void draw_question(const PanelContext& context, bool is_left) {
    FileDialogState& dialog = context.panels.file_dialog;
    const fs::path path = *dialog.to_replace;
    ImGui::SetCursorPosY(ImGui::GetWindowHeight() - context.px(42));
    const std::string question = sentence("Replace {name}? It exists already.", {{"name", path.filename().string()}});
    ImGui::TextUnformatted(elided(question, context.fonts.text, context.px(330)).c_str());
    report_item(context, "dialog question", path.string());
    show_cut_text(context, path.string(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    place_buttons(context, "Keep", "Replace");
    const bool is_kept = draw_label_button(context, "dialog keep", "Keep");
    ImGui::SameLine();
    const bool is_replaced = draw_label_button(context, "dialog replace", "Replace", ButtonLook::primary);
    if (is_replaced || was_pressed(context, editor::Key::enter)) context.queue.run(editor::SaveAs{.path = path});
    if (is_replaced || is_kept || is_left || was_pressed(context, editor::Key::enter)) {
        dialog.to_replace.reset();
        dialog.takes_focus = true;
    }
}

void draw_answers(const PanelContext& context, bool is_left) {
    const char* accept_label = is_saving(context) ? "Save" : "Open";
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
    const bool is_open = context.state.dialog == editor::Dialog::open_file || is_saving(context);
    if (!is_open) {
        dialog.was_open = false;
        return;
    }
    if (!dialog.was_open) begin_choice(context);
    DialogFrame frame;
    frame.title = is_saving(context) ? "Save as" : "Open";
    frame.size = {640.0, 520.0};
    frame.closes_on_outside = false;
    const bool is_left = begin_dialog(context, window, frame);
    move_choice(context);
    draw_folder_row(context);
    const float below = context.px(46 + 34 + 6) + 3.0F * ImGui::GetTextLineHeight();
    draw_entries(context, -below);
    draw_name_field(context);
    draw_problem(context);
    if (dialog.to_replace) {
        draw_question(context, is_left);
    } else {
        draw_answers(context, is_left);
    }
    end_dialog();
}

}  // namespace batten::ui
