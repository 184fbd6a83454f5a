#include "app/ui/triangle_view.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/derived/blend_lines.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/formula.h"
#include "app/ui/inspector_widgets.h"
#include "app/ui/panel_hover.h"
#include "app/ui/section.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

// Design pixels.
constexpr double largest_cell = 57.0;
constexpr double least_cell = 38.0;
constexpr double cell_height = 25.0;
constexpr double row_pitch = 40.0;
constexpr double cell_share = 0.7;   // of a column's pitch
constexpr double cell_margin = 2.0;  // for the outlines
constexpr double most_height = 246.0;
constexpr double bar_height = 10.0;
constexpr double faded_opacity = 0.3;

/// Where the cells are.
struct Grid {
    ImVec2 origin;
    float cell_width = 0.0F;
    float cell_height = 0.0F;
    float pitch_x = 0.0F;
    float pitch_y = 0.0F;
    std::size_t degree = 0;

    /// The upper left corner of cell j of level r.
    ImVec2 corner(std::size_t r, std::size_t j) const {
        return {origin.x + static_cast<float>(r) * pitch_x,
                origin.y + (static_cast<float>(j) + 0.5F * static_cast<float>(r)) * pitch_y};
    }
    ImVec2 left(std::size_t r, std::size_t j) const { return {corner(r, j).x, corner(r, j).y + 0.5F * cell_height}; }
    ImVec2 right(std::size_t r, std::size_t j) const { return {corner(r, j).x + cell_width, left(r, j).y}; }
    ImVec2 size() const {
        return {static_cast<float>(degree) * pitch_x + cell_width, static_cast<float>(degree) * pitch_y + cell_height};
    }
};

/// All columns fit into `width_px` as long as cells stay legible.
Grid grid_for(const PanelContext& context, std::size_t degree, float width_px) {
    const float columns = 1.0F + static_cast<float>(degree) / static_cast<float>(cell_share);
    Grid grid;
    grid.degree = degree;
    grid.cell_width = std::floor(std::clamp(width_px / columns, context.px(least_cell), context.px(largest_cell)));
    grid.cell_height = context.px(cell_height);
    grid.pitch_x = grid.cell_width / static_cast<float>(cell_share);
    grid.pitch_y = context.px(row_pitch);
    return grid;
}

/// One picture of a triangle.
class TrianglePicture {
  public:
    TrianglePicture(const PanelContext& context, const core::Curve& curve, const core::DeBoorTriangle& triangle,
                    const Grid& grid, std::size_t last_level)
        : context_(context), curve_(curve), triangle_(triangle), grid_(grid), last_level_(last_level) {}

    void draw() const {
        for (std::size_t r = 1; r < triangle_.levels.size(); ++r)
            for (std::size_t j = 0; j < triangle_.levels[r].size(); ++j) draw_lines(r, j);
        for (std::size_t r = 0; r < triangle_.levels.size(); ++r)
            for (std::size_t j = 0; j < triangle_.levels[r].size(); ++j) draw_cell(r, j);
    }

  private:
    double opacity(std::size_t r) const { return r > last_level_ ? faded_opacity : 1.0; }

    bool is_hovered(std::size_t r, std::size_t j) const {
        return editor::is_lit_cell(context_.state, triangle_, {r, j});
    }

    render::Color level_color(std::size_t r, std::size_t j) const {
        if (r > 0) return context_.theme.level(r);
        return context_.theme.point(editor::point_hue(*context_.state.shown().active_curve(),
                                                      triangle_.levels[0][j].index % curve_.control_points().size()));
    }

    /// The two lines into the cell; the larger the share of a point, the stronger its line.
    void draw_lines(std::size_t r, std::size_t j) const {
        const double alpha = triangle_.levels[r][j].alpha;
        draw_line(r, j, j, 1.0 - alpha);
        draw_line(r, j, j + 1, alpha);
    }

    void draw_line(std::size_t r, std::size_t j, std::size_t from, double share) const {
        const double strength = is_hovered(r, j) ? 1.0 : 0.3 + 0.7 * share;
        const render::Color color = render::faded(level_color(r, j), opacity(r) * strength);
        ImGui::GetWindowDrawList()->AddLine(grid_.right(r - 1, from), grid_.left(r, j), imgui_packed(color),
                                            context_.px(0.8 + 1.4 * share));
    }

    void draw_cell(std::size_t r, std::size_t j) const {
        const ImVec2 lower = grid_.corner(r, j);
        const ImVec2 upper(lower.x + grid_.cell_width, lower.y + grid_.cell_height);
        if (!ImGui::IsRectVisible(lower, ImVec2(upper.x, upper.y + context_.px(row_pitch - cell_height)))) return;
        ImGui::SetCursorScreenPos(lower);
        ImGui::Dummy(ImVec2(grid_.cell_width, grid_.cell_height));
        if (ImGui::IsItemHovered()) wish_hover(context_, editor::HoveredCell{r, j});
        draw_box(r, j, lower, upper);
        draw_texts(r, j, ImVec2(0.5F * (lower.x + upper.x), 0.5F * (lower.y + upper.y)), upper.y);
        report(r, j);
    }

    void draw_box(std::size_t r, std::size_t j, ImVec2 lower, ImVec2 upper) const {
        const editor::Theme& theme = context_.theme;
        const render::Color color = level_color(r, j);
        const render::Color fill = is_hovered(r, j) ? render::blended(color, 0.25, theme.field) : theme.field;
        const render::Color edge = render::blended(color, opacity(r) * (is_hovered(r, j) ? 1.0 : 0.75), theme.field);
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->AddRectFilled(lower, upper, imgui_packed(fill), context_.px(6));
        list->AddRect(lower, upper, imgui_packed(edge), context_.px(6), 0, context_.px(1.5));
    }

    void draw_texts(std::size_t r, std::size_t j, ImVec2 center, float bottom) const {
        const editor::Theme& theme = context_.theme;
        const bool is_last = r + 1 == triangle_.levels.size();
        const render::Color color = render::faded(is_last ? theme.parameter : theme.text, opacity(r));
        const float room = grid_.cell_width - context_.px(4);
        draw_text(context_, center, {name(r, j), context_.fonts.text, 0.0, color, render::Anchor::center, room});
        if (r == 0) return;
        draw_text(context_, ImVec2(center.x, bottom + context_.px(7)),
                  {alpha_text(r, j), context_.fonts.small, 0.0, render::faded(theme.dim, opacity(r)),
                   render::Anchor::center, grid_.pitch_x - context_.px(2)});
    }

    editor::NamedTriangle named() const { return {curve_, triangle_, context_.state.view.notation}; }

    std::string name(std::size_t r, std::size_t j) const {
        return editor::notated(named().point({r, j}), context_.state.view.notation);
    }

    std::string alpha_text(std::size_t r, std::size_t j) const {
        return fmt::format("α {}",
                           editor::share_texts(context_.state.view.notation, triangle_.levels[r][j].alpha).upper);
    }

    void report(std::size_t r, std::size_t j) const {
        const std::string cell = editor::plain_text(name(r, j));
        report_item(context_, fmt::format("cell {} {}", r, j),
                    r == 0 ? cell : fmt::format("{} {}", cell, alpha_text(r, j)));
    }

    const PanelContext& context_;
    const core::Curve& curve_;
    const core::DeBoorTriangle& triangle_;
    Grid grid_;
    std::size_t last_level_;
};

}  // namespace

void draw_triangle(const PanelContext& context, const core::Curve& curve, const core::DeBoorTriangle& triangle,
                   std::size_t last_level, float width_px) {
    const std::size_t degree = triangle.levels.size() - 1;
    const float edge = context.px(cell_margin);
    Grid grid = grid_for(context, degree, width_px - 2.0F * edge);
    const ImVec2 size(grid.size().x + 2.0F * edge, grid.size().y + 2.0F * edge);
    const bool is_wide = size.x > width_px + 0.5F;
    const float whole = size.y + (is_wide ? context.px(bar_height) : 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild("triangle", ImVec2(width_px, std::min(whole, context.px(most_height))), false,
                      is_wide ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_None);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    grid.origin = ImVec2(corner.x + edge, corner.y + edge);
    TrianglePicture(context, curve, triangle, grid, last_level).draw();
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy(size);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace batten::ui
