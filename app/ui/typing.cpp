#include "app/ui/typing.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/words/reading_text.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

constexpr int frames_between_requests = 4;

/// Lets the input grow `typed`, and keeps Tab, which ends the typing, out of it.
int on_input(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCharFilter) return data->EventChar == '\t' ? 1 : 0;
    auto& typed = *static_cast<std::string*>(data->UserData);
    typed.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = typed.data();
    return 0;
}

/// Returns whether Enter was pressed.
bool draw_input(const PanelContext& context, ImVec2 size) {
    FieldState& field = context.panels.field;
    ImFont* font = context.fonts.number;
    ImGui::PushFont(font);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(8), 0.5F * (size.y - font_height(font))));
    ImGui::SetNextItemWidth(size.x);
    ImGui::PushID(static_cast<int>(field.active_id));
    const bool is_entered = ImGui::InputText(
        "##typing", field.typed.data(), field.typed.capacity() + 1,
        ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AllowTabInput |
            ImGuiInputTextFlags_CallbackCharFilter | ImGuiInputTextFlags_CallbackResize,
        on_input, &field.typed);
    ImGui::PopID();
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return is_entered;
}

void end_typing(FieldState& field) {
    field.active_id = 0;
    field.is_typing = false;
}

void draw_outline(const PanelContext& context) {
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        imgui_packed(context.theme.accent), context.px(5), 0, context.px(1.2));
}

TextEvents typed_text(const PanelContext& context, const TextField& field, ImVec2 size) {
    TextEvents events;
    FieldState& state = context.panels.field;
    const TypingStep step = draw_typing(context, size);
    report_item(context, field.name, state.typed);
    const bool counts = step == TypingStep::ended || step == TypingStep::entered;
    if (counts && state.typed != state.original) events.typed = state.typed;
    return events;
}

TextEvents shown_text(const PanelContext& context, const TextField& field, ImVec2 size) {
    TextEvents events;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const bool is_clicked = ImGui::InvisibleButton(field.name.c_str(), size) && field.is_enabled;
    const bool is_lit = field.is_enabled && ImGui::IsItemHovered();
    if (field.has_frame) draw_field_frame(context, origin, size, is_lit);
    if (is_lit && !field.needs_double_click) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    const float padding = field.has_frame ? context.px(8) : 0.0F;
    const render::Color color = field.is_enabled ? context.theme.text : context.theme.dim;
    const ImVec2 left(origin.x + padding, origin.y + 0.5F * size.y);
    const std::string shown = elided(field.shown, field.font, size.x - 2.0F * padding);
    draw_text(context, left, {.text = shown, .font = field.font, .color = color, .is_typed = true});
    report_item(context, field.name, field.shown);
    const std::string tooltip = context.notated(field.tooltip);
    show_typed_tooltip(context, shown == field.shown ? tooltip : fmt::format("{}\n{}", field.shown, tooltip));
    const bool is_double = is_lit && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    events.begins = field.is_enabled && (field.needs_double_click ? is_double : is_clicked);
    events.is_clicked = is_clicked && !events.begins;
    return events;
}

/// A sentence in a frame below the last item, over everything else.
void draw_note(const PanelContext& context, const std::string& problem) {
    ImFont* font = context.fonts.text;
    const float wrap = context.px(280);
    const ImVec2 text = font->CalcTextSizeA(font_height(font), wrap, wrap, problem.c_str());
    const ImVec2 padding(context.px(9), context.px(6));
    const ImVec2 size(text.x + 2.0F * padding.x, text.y + 2.0F * padding.y);
    const float right_most = ImGui::GetIO().DisplaySize.x - size.x - context.px(4);
    const ImVec2 lower(std::min(ImGui::GetItemRectMin().x, right_most), ImGui::GetItemRectMax().y + context.px(4));
    const ImVec2 upper(lower.x + size.x, lower.y + size.y);
    ImDrawList* list = ImGui::GetForegroundDrawList();
    list->AddRectFilled(lower, upper, imgui_packed(context.theme.panel), context.px(5));
    list->AddRect(lower, upper, imgui_packed(context.theme.error), context.px(5), 0, context.px(1.2));
    list->AddText(font, font_height(font), ImVec2(lower.x + padding.x, lower.y + padding.y),
                  imgui_packed(context.theme.text), problem.c_str(), nullptr, wrap);
    context.widgets.push_back({"field problem", {{lower.x, lower.y}, {size.x, size.y}}, problem});
}

}  // namespace

void begin_typing(FieldState& field, unsigned id, std::string text) {
    field.active_id = id;
    field.is_typing = true;
    field.is_dragging = false;
    field.original = text;
    field.typed = std::move(text);
    field.has_keyboard = false;
    field.frames_waited = 0;
    field.first_frame = ImGui::GetFrameCount();
    field.last_frame = ImGui::GetFrameCount();
    field.problem_id = 0;
    field.begins_next = false;
    field.wanted_id = 0;
}

bool is_typing(const FieldState& field, unsigned id) {
    return field.is_typing && field.active_id == id;
}

bool is_pressed(const PanelContext& context, editor::Key key) {
    const auto& presses = context.input.key_presses;
    return std::any_of(presses.begin(), presses.end(),
                       [key](const KeyPress& press) { return press.shortcut.key == key; });
}

TypingStep draw_typing(const PanelContext& context, ImVec2 size) {
    FieldState& field = context.panels.field;
    field.last_frame = ImGui::GetFrameCount();
    // A request in every frame would select the text again under the first typed letter.
    if (!field.has_keyboard && field.frames_waited++ % frames_between_requests == 0) ImGui::SetKeyboardFocusHere();
    const bool is_entered = draw_input(context, size);
    draw_outline(context);
    const bool is_left = field.has_keyboard && !ImGui::IsItemActive();
    field.has_keyboard = field.has_keyboard || ImGui::IsItemActive();
    TypingStep step = TypingStep::goes_on;
    if (field.first_frame == ImGui::GetFrameCount()) return step;
    if (is_pressed(context, editor::Key::escape)) {
        step = TypingStep::escaped;
    } else if (is_entered) {
        step = TypingStep::entered;
    } else if (is_left || is_pressed(context, editor::Key::tab)) {
        step = TypingStep::ended;
    }
    if (step != TypingStep::goes_on) end_typing(field);
    return step;
}

void set_problem(FieldState& field, unsigned id, std::string sentence) {
    field.problem_id = id;
    field.problem = std::move(sentence);
    field.problem_frame = ImGui::GetFrameCount();
}

void draw_problem(const PanelContext& context, unsigned id) {
    FieldState& field = context.panels.field;
    if (field.problem_id != id) return;
    draw_note(context, context.notated(editor::reading_text(field.problem)));
    // The click that ended the typing must not take the note away at once.
    const bool is_new = field.problem_frame == ImGui::GetFrameCount();
    if (!is_new && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) field.problem_id = 0;
}

TextEvents draw_text_field(const PanelContext& context, const TextField& field) {
    const unsigned id = ImGui::GetID(field.name.c_str());
    const ImVec2 size(field.width_px, context.px(field.height));
    TextEvents events =
        is_typing(context.panels.field, id) ? typed_text(context, field, size) : shown_text(context, field, size);
    events.id = id;
    return events;
}

}  // namespace batten::ui
