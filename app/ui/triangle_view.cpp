#include "app/ui/triangle_view.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/editor/cards/cell_grid.h"
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
constexpr editor::CellShape construction_cells{
    .widths = {38.0, 57.0}, .height = 25.0, .row_pitch = 40.0, .column_share = 0.7};
constexpr double most_height = 246.0;
constexpr double bar_height = 10.0;
constexpr double faded_opacity = 0.3;

ImVec2 imgui_place(glm::dvec2 place) {
    return {static_cast<float>(place.x), static_cast<float>(place.y)};
}

/// One picture of a triangle.
class TrianglePicture {
  public:
    TrianglePicture(const PanelContext& context, const core::Curve& curve, const core::DeBoorTriangle& triangle,
                    const editor::CellGrid& grid, std::size_t last_level)
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
        ImGui::GetWindowDrawList()->AddLine(imgui_place(grid_.right(r - 1, from)), imgui_place(grid_.left(r, j)),
                                            imgui_packed(color), context_.px(0.8 + 1.4 * share));
    }

    void draw_cell(std::size_t r, std::size_t j) const {
        const ImVec2 lower = imgui_place(grid_.box(r, j).lower_px);
        const ImVec2 upper = imgui_place(grid_.box(r, j).upper_px);
        const double gap = construction_cells.row_pitch - construction_cells.height;
        if (!ImGui::IsRectVisible(lower, ImVec2(upper.x, upper.y + context_.px(gap)))) return;
        ImGui::SetCursorScreenPos(lower);
        ImGui::Dummy(imgui_place(grid_.cell));
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
        const float room = static_cast<float>(grid_.cell.x) - context_.px(4);
        draw_text(context_, center, {name(r, j), context_.fonts.text, 0.0, color, render::Anchor::center, room});
        if (r == 0) return;
        draw_text(context_, ImVec2(center.x, bottom + context_.px(7)),
                  {alpha_text(r, j), context_.fonts.small, 0.0, render::faded(theme.dim, opacity(r)),
                   render::Anchor::center, static_cast<float>(grid_.pitch.x) - context_.px(2)});
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
    editor::CellGrid grid_;
    std::size_t last_level_;
};

}  // namespace

void draw_triangle(const PanelContext& context, const core::Curve& curve, const core::DeBoorTriangle& triangle,
                   std::size_t last_level, float width_px) {
    const std::size_t degree = triangle.levels.size() - 1;
    editor::CellGrid grid = construction_cells.placed(degree, width_px, context.scale);
    const ImVec2 size = imgui_place(
        {grid.box(degree, 0).upper_px.x + grid.origin.x, context.scale * construction_cells.height_of_all(degree)});
    const bool is_wide = size.x > width_px + 0.5F;
    const float whole = size.y + (is_wide ? context.px(bar_height) : 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild("triangle", ImVec2(width_px, std::min(whole, context.px(most_height))), false,
                      is_wide ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_None);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    grid.origin += glm::dvec2(corner.x, corner.y);
    TrianglePicture(context, curve, triangle, grid, last_level).draw();
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy(size);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace batten::ui
