#include "app/ui/card_view.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/words/formula.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panel_hover.h"
#include "app/ui/picture_item.h"
#include "app/ui/rich_text.h"
#include "app/ui/style.h"
#include "app/ui/text_lines.h"

namespace batten::ui {

namespace {

using editor::CardText;
using editor::CardTone;

// Design pixels.
constexpr double line_gap = 3.0;
constexpr double column_gap = 14.0;
constexpr double row_padding = 3.0;
constexpr double button_padding = 12.0;
constexpr double scroll_bar_height = 10.0;
constexpr std::size_t most_text_lines = 12;

render::Color color_of(const editor::Theme& theme, const CardText& text) {
    if (text.color) return *text.color;
    switch (text.tone) {
        case CardTone::plain:
        case CardTone::strong:
            return theme.text;
        case CardTone::dim:
            return theme.dim;
        case CardTone::good:
        case CardTone::accent:
            return theme.accent;
        case CardTone::bad:
            return theme.error;
        case CardTone::parameter:
            return theme.parameter;
    }
    return theme.text;
}

bool has_hover(const editor::Hover& hover) {
    return !std::holds_alternative<editor::HoveredNothing>(hover);
}

/// One drawing of the blocks of a card.
class CardPainter {
  public:
    CardPainter(const PanelContext& context, std::string name, float width_px)
        : context_(context), name_(std::move(name)), width_(width_px) {}

    void operator()(const editor::CardLine& line) {
        ImFont* font = line.is_formula                      ? context_.fonts.number
                       : line.text.tone == CardTone::strong ? context_.fonts.bold
                                                            : context_.fonts.text;
        const std::string text = editor::notated(line.text.text, context_.state.view.notation);
        const TextLines lines = broken_into_lines(text, font, width_, most_text_lines);
        const float pitch = std::round(font_pitch(font));
        const ImVec2 size(width_, pitch * static_cast<float>(lines.lines.size()));
        begin_item(size);
        point_at(line.text, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
        const ImVec2 corner = ImGui::GetItemRectMin();
        for (std::size_t i = 0; i < lines.lines.size(); ++i)
            draw_text(context_, ImVec2(corner.x, corner.y + (static_cast<float>(i) + 0.5F) * pitch),
                      {lines.lines[i], font, 0.0, color_of(context_.theme, line.text)});
        report_item(context_, fmt::format("{} line {}", name_, row_++), editor::plain_text(text));
    }

    void operator()(const editor::CardTable& table) {
        const std::vector<float> widths = column_widths(table);
        float whole = -context_.px(column_gap);
        for (const float width : widths) whole += width + context_.px(column_gap);
        for (std::size_t r = 0; r < table.rows.size(); ++r)
            if (is_across(table, r)) whole = std::max(whole, text_width(table, r, 0));
        const float row_height = std::round(font_pitch(context_.fonts.text) + 2.0F * context_.px(row_padding));
        begin_block(whole, row_height * static_cast<float>(table.rows.size()));
        for (std::size_t r = 0; r < table.rows.size(); ++r)
            draw_row(table, r, is_across(table, r) ? std::vector<float>{whole} : widths,
                     block_corner_.y + static_cast<float>(r) * row_height, row_height);
        end_block();
        row_ += table.rows.size();
    }

    void operator()(const editor::CardPicture& picture) {
        const float height = context_.px(picture.height);
        const float width = std::max(width_, context_.px(picture.least_width));
        begin_block(width, height);
        const editor::CardDrawing drawing = picture.draw({width, height}, context_.scale);
        draw_picture(ImGui::GetWindowDrawList(), drawing.list, {block_corner_.x, block_corner_.y}, context_.fonts);
        for (const editor::CardPlace& place : drawing.places) report_place(place);
        end_block();
    }

    void operator()(const editor::CardButtons& block) {
        float x = 0.0F;
        for (const editor::CardButton& entry : block.buttons) {
            const std::string text = editor::notated(entry.text, context_.state.view.notation);
            const float wanted = rich_text_size(text, context_.fonts.text, font_pitch(context_.fonts.text)).width_px +
                                 2.0F * context_.px(button_padding);
            const float width = std::min(wanted, width_);
            if (x > 0.0F && x + width <= width_)
                ImGui::SameLine(0.0F, context_.px(6));
            else
                x = 0.0F;
            x += width + context_.px(6);
            Button button{fmt::format("{} button {}", name_, button_++), text, Icon::none, width};
            button.is_active = entry.is_active;
            draw_command_button(context_, button, entry.command);
        }
    }

  private:
    static float font_pitch(ImFont* font) { return 1.3F * font_height(font); }

    void begin_item(ImVec2 size) { ImGui::Dummy(size); }

    /// A part of the card that scrolls sideways where it is wider than the card.
    void begin_block(float width, float height) {
        is_wide_ = width > width_ + 0.5F;
        const float whole = height + (is_wide_ ? context_.px(scroll_bar_height) : 0.0F);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
        ImGui::BeginChild(fmt::format("{} block {}", name_, block_++).c_str(), ImVec2(width_, whole), false,
                          (is_wide_ ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_None) |
                              ImGuiWindowFlags_NoScrollWithMouse);
        block_corner_ = ImGui::GetCursorScreenPos();
        block_size_ = ImVec2(width, height);
    }

    void end_block() {
        ImGui::SetCursorScreenPos(block_corner_);
        ImGui::Dummy(block_size_);
        ImGui::EndChild();
        ImGui::PopStyleVar();
    }

    ImFont* font_of(const editor::CardTable& table, std::size_t row, const CardText& cell) const {
        const bool is_heading = table.has_heading && row == 0;
        return is_heading || cell.tone == CardTone::strong ? context_.fonts.bold : context_.fonts.text;
    }

    /// Whether the row reaches over all columns.
    static bool is_across(const editor::CardTable& table, std::size_t row) {
        return table.rows[row].size() == 1 &&
               std::ranges::any_of(table.rows, [](const auto& other) { return other.size() > 1; });
    }

    float text_width(const editor::CardTable& table, std::size_t row, std::size_t column) const {
        const CardText& cell = table.rows[row][column];
        ImFont* font = font_of(table, row, cell);
        return rich_text_size(editor::notated(cell.text, context_.state.view.notation), font, font_height(font))
            .width_px;
    }

    std::vector<float> column_widths(const editor::CardTable& table) const {
        std::vector<float> widths;
        for (std::size_t r = 0; r < table.rows.size(); ++r) {
            if (is_across(table, r)) continue;
            widths.resize(std::max(widths.size(), table.rows[r].size()));
            for (std::size_t c = 0; c < table.rows[r].size(); ++c)
                widths[c] = std::max(widths[c], text_width(table, r, c));
        }
        return widths;
    }

    void draw_row(const editor::CardTable& table, std::size_t r, const std::vector<float>& widths, float top,
                  float height) {
        float x = block_corner_.x;
        for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
            const CardText& cell = table.rows[r][c];
            const std::string text = editor::notated(cell.text, context_.state.view.notation);
            ImGui::SetCursorScreenPos(ImVec2(x, top));
            ImGui::Dummy(ImVec2(std::max(widths[c], 1.0F), height));
            const float half_gap = 0.5F * context_.px(column_gap);
            point_at(cell, ImVec2(x - half_gap, top), ImVec2(x + widths[c] + half_gap, top + height));
            draw_text(context_, ImVec2(x, top + 0.5F * height),
                      {text, font_of(table, r, cell), 0.0, color_of(context_.theme, cell)});
            report_item(context_, fmt::format("{} cell {} {}", name_, row_ + r, c), editor::plain_text(text));
            x += widths[c] + context_.px(column_gap);
        }
    }

    /// Lights what the text is about while the pointer is on it, and the text while that is lit elsewhere.
    void point_at(const CardText& text, ImVec2 lower, ImVec2 upper) {
        const bool is_under = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(lower, upper);
        if (is_under && has_hover(text.hover)) wish_hover(context_, text.hover);
        const bool is_lit =
            (has_hover(text.hover) && context_.state.hover == text.hover) || (is_under && text.command.has_value());
        if (is_lit)
            ImGui::GetWindowDrawList()->AddRectFilled(
                lower, upper, imgui_packed(render::faded(context_.theme.accent, 0.18)), context_.px(4));
        if (is_under && text.command && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) context_.queue.run(*text.command);
    }

    void report_place(const editor::CardPlace& place) {
        const glm::vec2 lower(place.box.lower_px);
        const glm::vec2 size(place.box.upper_px - place.box.lower_px);
        ImGui::SetCursorScreenPos(ImVec2(block_corner_.x + lower.x, block_corner_.y + lower.y));
        ImGui::Dummy(ImVec2(size.x, size.y));
        if (ImGui::IsItemHovered() && has_hover(place.hover)) wish_hover(context_, place.hover);
        report_item(context_, fmt::format("{} {}", name_, place.name), place.value);
    }

    const PanelContext& context_;
    std::string name_;
    float width_;
    ImVec2 block_corner_{};
    ImVec2 block_size_{};
    bool is_wide_ = false;
    std::size_t row_ = 0;
    std::size_t block_ = 0;
    std::size_t button_ = 0;
};

}  // namespace

void draw_card_blocks(const PanelContext& context, const editor::Card& card, const std::string& name, float width_px) {
    CardPainter painter(context, name, width_px);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(6), context.px(line_gap)));
    for (const editor::CardBlock& block : card.blocks) std::visit(painter, block);
    ImGui::PopStyleVar();
}

}  // namespace batten::ui
