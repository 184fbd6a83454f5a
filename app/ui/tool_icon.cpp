#include "app/ui/tool_icon.h"

#include <imgui.h>

#include <array>
#include <initializer_list>
#include <vector>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

/// Draws in the unit square: x to the right and y down, both from 0 to 1.
class IconPen {
  public:
    IconPen(ImDrawList* list, const IconPlace& place, render::Color color)
        : list_(list), place_(place), color_(imgui_packed(color)), width_px_(place.size_px * 0.095F) {}

    void line(std::initializer_list<ImVec2> points, bool is_closed = false) const {
        const std::vector<ImVec2> pixels = scaled(points);
        list_->AddPolyline(pixels.data(), static_cast<int>(pixels.size()), color_,
                           is_closed ? ImDrawFlags_Closed : ImDrawFlags_None, width_px_);
    }
    void area(std::initializer_list<ImVec2> points) const {
        const std::vector<ImVec2> pixels = scaled(points);
        list_->AddConvexPolyFilled(pixels.data(), static_cast<int>(pixels.size()), color_);
    }
    void cubic(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) const {
        list_->AddBezierCubic(at(a), at(b), at(c), at(d), color_, width_px_);
    }
    void disc(ImVec2 center, float radius) const {
        list_->AddCircleFilled(at(center), radius * place_.size_px, color_);
    }
    void ring(ImVec2 center, float radius) const {
        list_->AddCircle(at(center), radius * place_.size_px, color_, 0, width_px_);
    }
    void arc(ImVec2 center, float radius, float from, float to) const {
        list_->PathArcTo(at(center), radius * place_.size_px, from, to);
        list_->PathStroke(color_, ImDrawFlags_None, width_px_);
    }

  private:
    ImVec2 at(ImVec2 p) const {
        return {place_.x_px + (p.x - 0.5F) * place_.size_px, place_.y_px + (p.y - 0.5F) * place_.size_px};
    }
    std::vector<ImVec2> scaled(std::initializer_list<ImVec2> points) const {
        std::vector<ImVec2> pixels;
        for (const ImVec2& point : points) pixels.push_back(at(point));
        return pixels;
    }

    ImDrawList* list_;
    IconPlace place_;
    ImU32 color_;
    float width_px_;
};

void draw_select(const IconPen& pen) {
    pen.line({{0.24F, 0.10F},
              {0.24F, 0.82F},
              {0.43F, 0.64F},
              {0.56F, 0.92F},
              {0.68F, 0.86F},
              {0.56F, 0.59F},
              {0.80F, 0.58F}},
             true);
}

void draw_add_point(const IconPen& pen) {
    pen.line({{0.5F, 0.12F}, {0.5F, 0.88F}});
    pen.line({{0.12F, 0.5F}, {0.88F, 0.5F}});
}

void draw_insert_knot(const IconPen& pen) {
    pen.line({{0.5F, 0.24F}, {0.76F, 0.5F}, {0.5F, 0.76F}, {0.24F, 0.5F}}, true);
    pen.line({{0.0F, 0.5F}, {0.24F, 0.5F}});
    pen.line({{0.76F, 0.5F}, {1.0F, 0.5F}});
}

void draw_weight(const IconPen& pen) {
    constexpr float sixth = 1.0471976F;
    pen.disc({0.5F, 0.5F}, 0.15F);
    for (int i = 0; i < 6; ++i) {
        const float from = static_cast<float>(i) * sixth;
        pen.arc({0.5F, 0.5F}, 0.4F, from, from + 0.6F * sixth);
    }
}

void draw_draw_curve(const IconPen& pen) {
    pen.cubic({0.14F, 0.82F}, {0.30F, -0.22F}, {0.62F, 1.10F}, {0.86F, 0.20F});
    pen.disc({0.14F, 0.82F}, 0.11F);
    pen.disc({0.86F, 0.20F}, 0.11F);
}

void draw_parameter(const IconPen& pen) {
    pen.cubic({0.05F, 0.80F}, {0.20F, 0.30F}, {0.70F, 0.20F}, {0.95F, 0.62F});
    pen.disc({0.47F, 0.40F}, 0.14F);
    pen.line({{0.47F, 0.40F}, {0.47F, 0.95F}});
}

void draw_pencil(const IconPen& pen) {
    pen.line({{0.12F, 0.88F}, {0.20F, 0.62F}, {0.70F, 0.12F}, {0.88F, 0.30F}, {0.38F, 0.80F}}, true);
    pen.line({{0.58F, 0.24F}, {0.76F, 0.42F}});
}

void draw_undo(const IconPen& pen) {
    pen.line({{0.36F, 0.14F}, {0.14F, 0.36F}, {0.36F, 0.58F}});
    pen.line({{0.14F, 0.36F}, {0.60F, 0.36F}});
    pen.arc({0.60F, 0.60F}, 0.24F, -1.5708F, 1.5708F);
    pen.line({{0.60F, 0.84F}, {0.36F, 0.84F}});
}

void draw_redo(const IconPen& pen) {
    pen.line({{0.64F, 0.14F}, {0.86F, 0.36F}, {0.64F, 0.58F}});
    pen.line({{0.86F, 0.36F}, {0.40F, 0.36F}});
    pen.arc({0.40F, 0.60F}, 0.24F, 1.5708F, 4.7124F);
    pen.line({{0.40F, 0.84F}, {0.64F, 0.84F}});
}

void draw_fit(const IconPen& pen) {
    pen.line({{0.12F, 0.34F}, {0.12F, 0.12F}, {0.34F, 0.12F}});
    pen.line({{0.66F, 0.12F}, {0.88F, 0.12F}, {0.88F, 0.34F}});
    pen.line({{0.88F, 0.66F}, {0.88F, 0.88F}, {0.66F, 0.88F}});
    pen.line({{0.34F, 0.88F}, {0.12F, 0.88F}, {0.12F, 0.66F}});
    pen.ring({0.5F, 0.5F}, 0.13F);
}

void draw_play(const IconPen& pen) {
    pen.area({{0.26F, 0.14F}, {0.86F, 0.5F}, {0.26F, 0.86F}});
}

void draw_shape(const IconPen& pen) {
    pen.ring({0.62F, 0.36F}, 0.26F);
    pen.line({{0.12F, 0.46F}, {0.56F, 0.46F}, {0.56F, 0.9F}, {0.12F, 0.9F}}, true);
}

/// Two ends with a dashed way between them.
void draw_joint(const IconPen& pen) {
    pen.cubic({0.06F, 0.86F}, {0.1F, 0.5F}, {0.2F, 0.34F}, {0.36F, 0.3F});
    pen.cubic({0.64F, 0.3F}, {0.8F, 0.34F}, {0.9F, 0.5F}, {0.94F, 0.86F});
    pen.disc({0.36F, 0.3F}, 0.1F);
    pen.disc({0.64F, 0.3F}, 0.1F);
}

/// A circle with points that are fainter toward its rim.
void draw_brush(const IconPen& pen) {
    pen.ring({0.5F, 0.5F}, 0.4F);
    pen.disc({0.5F, 0.5F}, 0.11F);
    pen.disc({0.28F, 0.5F}, 0.06F);
    pen.disc({0.72F, 0.5F}, 0.06F);
}

/// A box with handles at its corners.
void draw_transform(const IconPen& pen) {
    pen.line({{0.2F, 0.2F}, {0.8F, 0.2F}, {0.8F, 0.8F}, {0.2F, 0.8F}}, true);
    for (const float x : {0.2F, 0.8F})
        for (const float y : {0.2F, 0.8F}) pen.disc({x, y}, 0.11F);
}

/// A magnet.
void draw_snapping(const IconPen& pen) {
    constexpr float half_turn = 3.14159265F;
    pen.arc({0.5F, 0.5F}, 0.34F, 0.0F, half_turn);
    pen.line({{0.16F, 0.5F}, {0.16F, 0.16F}});
    pen.line({{0.84F, 0.5F}, {0.84F, 0.16F}});
    pen.line({{0.06F, 0.3F}, {0.26F, 0.3F}});
    pen.line({{0.74F, 0.3F}, {0.94F, 0.3F}});
}

using editor::TakeTool;
using editor::Tool;

struct ToolIcon {
    const editor::CommandSpec& (*spec)();
    void (*draw)(const IconPen&);
};

constexpr std::array icons{ToolIcon{TakeTool<Tool::select>::spec, draw_select},
                           ToolIcon{TakeTool<Tool::add_point>::spec, draw_add_point},
                           ToolIcon{TakeTool<Tool::insert_knot>::spec, draw_insert_knot},
                           ToolIcon{TakeTool<Tool::weight>::spec, draw_weight},
                           ToolIcon{TakeTool<Tool::draw_curve>::spec, draw_draw_curve},
                           ToolIcon{TakeTool<Tool::parameter>::spec, draw_parameter},
                           ToolIcon{TakeTool<Tool::shape>::spec, draw_shape},
                           ToolIcon{TakeTool<Tool::joint>::spec, draw_joint},
                           ToolIcon{TakeTool<Tool::brush>::spec, draw_brush},
                           ToolIcon{TakeTool<Tool::transform>::spec, draw_transform},
                           ToolIcon{editor::SetSnap::spec, draw_snapping},
                           ToolIcon{TakeTool<Tool::pencil>::spec, draw_pencil},
                           ToolIcon{editor::Undo::spec, draw_undo},
                           ToolIcon{editor::Redo::spec, draw_redo},
                           ToolIcon{editor::FitView::spec, draw_fit},
                           ToolIcon{editor::TogglePlay::spec, draw_play}};

}  // namespace

void draw_icon(ImDrawList* list, const editor::CommandSpec& spec, const IconPlace& place, render::Color color) {
    for (const ToolIcon& icon : icons)
        if (&icon.spec() == &spec) icon.draw(IconPen(list, place, color));
}

}  // namespace batten::ui
