#include "app/ui/form_row.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <limits>
#include <string_view>

#include "app/editor/state/state.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/style.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::ui {

namespace {

using editor::Field;
using editor::FieldKind;
using editor::FieldPart;

constexpr double name_width = 104.0;
constexpr double meaning_gap = 2.0;
constexpr double form_row_gap = 8.0;
constexpr double field_gap = 6.0;

void draw_text_input(const PanelContext& context, const FieldPart& part, std::string& text, float width) {
    FormState& form = context.panels.form;
    if (form.takes_focus && (form.focused.empty() || form.focused == part.name)) {
        ImGui::SetKeyboardFocusHere();
        form.takes_focus = false;
    }
    ImGui::PushFont(context.fonts.number);
    ImGui::SetNextItemWidth(width);
    ImGui::InputText(fmt::format("##{}", part.name).c_str(), &text, ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) form.focused = part.name;
    ImGui::PopFont();
    report_item(context, fmt::format("form {}", part.name), text);
}

template <class Choices, class NameOf, class TitleOf>
void draw_combo(const PanelContext& context, const FieldPart& part, std::string& text, float width,
                const Choices& choices, NameOf name_of, TitleOf title_of) {
    std::string shown = text;
    for (const auto& choice : choices)
        if (text == name_of(choice)) shown = title_of(choice);
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo(fmt::format("##{}", part.name).c_str(), shown.c_str());
    report_item(context, fmt::format("form {}", part.name), text);
    if (!is_open) return;
    for (const auto& choice : choices) {
        if (ImGui::Selectable(title_of(choice), text == name_of(choice))) text = name_of(choice);
        report_item(context, fmt::format("form {} {}", part.name, name_of(choice)));
    }
    ImGui::EndCombo();
}

void draw_choice_field(const PanelContext& context, const Field& field, std::string& text, float width) {
    draw_combo(
        context, field.parts.front(), text, width, field.choices, [](const editor::Choice& c) { return c.name; },
        [](const editor::Choice& c) { return c.title; });
}

void draw_flag(const PanelContext& context, const Field& field, std::string& text, float width) {
    static constexpr std::array words{"yes", "no"};
    const auto itself = [](const char* word) { return word; };
    draw_combo(context, field.parts.front(), text, width, words, itself, itself);
}

/// The curves of the document but the active one.
void draw_curve_names(const PanelContext& context, const Field& field, std::string& text, float width) {
    const core::Document& document = context.state.history.present();
    std::vector<const char*> names;
    for (std::size_t i = 0; i < document.curves.size(); ++i)
        if (i != document.active) names.push_back(document.curves[i].name.c_str());
    const auto itself = [](const char* name) { return name; };
    draw_combo(context, field.parts.front(), text, width, names, itself, itself);
}

void draw_inputs(const PanelContext& context, const Field& field, std::vector<std::string>& texts, float width) {
    switch (field.kind) {
        case FieldKind::choice:
            return draw_choice_field(context, field, texts.front(), width);
        case FieldKind::flag:
            return draw_flag(context, field, texts.front(), width);
        case FieldKind::curve_name:
            return draw_curve_names(context, field, texts.front(), width);
        default:
            break;
    }
    const auto count = static_cast<float>(texts.size());
    const float gap = context.px(field_gap);
    for (std::size_t k = 0; k < texts.size(); ++k) {
        if (k > 0) ImGui::SameLine(0.0F, gap);
        draw_text_input(context, field.parts[k], texts[k], (width - (count - 1.0F) * gap) / count);
    }
}

std::string name_of(const Field& field) {
    return field.parts.size() == 1 ? field.parts[0].name
                                   : fmt::format("{}, {}", field.parts[0].name, field.parts[1].name);
}

std::string meaning_of(const PanelContext& context, const Field& field) {
    return context.notated(field.parts.size() == 1
                               ? field.parts[0].meaning
                               : fmt::format("{}; {}", field.parts[0].meaning, field.parts[1].meaning));
}

/// The meaning of a degree with the order that belongs to `text`, where the notation has orders.
std::string meaning_with_order(const PanelContext& context, const Field& field, const std::string& text) {
    std::string meaning = meaning_of(context, field);
    const bool has_order = context.state.view.notation.degree == editor::DegreeOrOrder::order;
    const auto degree = core::leading_number(text);
    if (!has_order || field.kind != FieldKind::count || std::string_view(field.parts[0].name) != "degree" || !degree)
        return meaning;
    return core::sentence("{meaning}; k = {order}",
                          {{"meaning", meaning}, {"order", core::shortest_text(degree->value + 1.0)}});
}

}  // namespace

float wrapped_height_px(const std::string& text, ImFont* font, float width_px) {
    return font->CalcTextSizeA(font_height(font), std::numeric_limits<float>::max(), width_px, text.c_str()).y;
}

float form_row_height_px(const PanelContext& context, const editor::Field& field, float width_px) {
    const float meaning = wrapped_height_px(meaning_with_order(context, field, "25"), context.fonts.small,
                                            width_px - context.px(name_width));
    return ImGui::GetFrameHeight() + context.px(meaning_gap) + meaning + context.px(form_row_gap);
}

void draw_form_row(const PanelContext& context, const editor::Field& field, std::vector<std::string>& texts) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float whole = ImGui::GetContentRegionAvail().x;
    const float left = context.px(name_width);
    draw_text(context, ImVec2(origin.x, origin.y + 0.5F * ImGui::GetFrameHeight()),
              {name_of(field), context.fonts.text, 0.0, context.theme.text, render::Anchor::left,
               context.px(name_width - 10.0)});
    ImGui::SetCursorScreenPos(ImVec2(origin.x + left, origin.y));
    draw_inputs(context, field, texts, whole - left);
    ImGui::GetWindowDrawList()->AddText(context.fonts.small, font_height(context.fonts.small),
                                        {origin.x + left, origin.y + ImGui::GetFrameHeight() + context.px(meaning_gap)},
                                        imgui_packed(context.theme.dim),
                                        meaning_with_order(context, field, texts.front()).c_str(), nullptr,
                                        whole - left);
    ImGui::SetCursorScreenPos({origin.x, origin.y + form_row_height_px(context, field, whole)});
}

}  // namespace batten::ui
