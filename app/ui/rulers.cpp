#include <imgui.h>

#include <cmath>

#include "app/editor/scene/ruler.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panels.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

using editor::RulerAxis;

constexpr double label_start = 3.0;  // behind its tick, in design pixels
constexpr double mark_size = 5.0;    // of the triangle where the pointer is

/// One ruler: `along` is its direction, `across` leads from the canvas to its far side.
class RulerPainter {
  public:
    RulerPainter(const PanelContext& context, RulerAxis axis, const Rectangle& rulers, const Rectangle& canvas)
        : context_(context), list_(ImGui::GetBackgroundDrawList()), axis_(axis), rulers_(rulers), canvas_(canvas) {}

    void draw() {
        const ImVec2 low = at(0.0, width());
        const ImVec2 high = at(length(), 0.0);
        list_->PushClipRect(low, high);
        for (const editor::RulerTick& tick : editor::ruler_ticks(context_.state, axis_)) draw_tick(tick);
        if (const auto& pointer = context_.panels.pointer.canvas_px)
            draw_mark(axis_ == RulerAxis::x ? pointer->x : pointer->y);
        list_->PopClipRect();
        const ImVec2 end = at(length(), 0.0);
        const ImVec2 edge = at(0.0, 0.0);
        list_->AddLine(edge, end, imgui_packed(context_.theme.line), context_.px(1));
    }

  private:
    double width() const { return canvas_.origin_px.x - rulers_.origin_px.x; }
    double length() const { return axis_ == RulerAxis::x ? canvas_.size_px.x : canvas_.size_px.y; }

    /// The place so far along the ruler, and so far from the canvas.
    ImVec2 at(double along, double across) const {
        const glm::dvec2 place =
            canvas_.origin_px + (axis_ == RulerAxis::x ? glm::dvec2(along, -across) : glm::dvec2(-across, along));
        return {static_cast<float>(place.x), static_cast<float>(place.y)};
    }

    void draw_tick(const editor::RulerTick& tick) {
        // On whole pixels, so that a line of one pixel is one at any scale.
        const double place = std::floor(tick.place_px);
        const ImVec2 from = at(place, 0.0);
        const ImVec2 to = at(place + std::max(1.0, std::floor(context_.scale)), tick.length * width());
        list_->AddRectFilled({std::min(from.x, to.x), std::min(from.y, to.y)},
                             {std::max(from.x, to.x), std::max(from.y, to.y)}, imgui_packed(context_.theme.dim));
        if (!tick.label.empty()) draw_label(tick.label, place);
    }

    /// To the right of its tick; on the left ruler turned, so that it reads upward. Nothing where it would be cut.
    void draw_label(const std::string& label, double place) {
        ImFont* font = context_.fonts.small;
        const double text = text_width(label, font);
        const double start = std::floor(context_.px(label_start));
        const double first_px = axis_ == RulerAxis::x ? place + start : place - start - text;
        if (first_px < 0.0 || first_px + text > length()) return;
        const ImVec2 corner = at(axis_ == RulerAxis::x ? place + start : place - start, width());
        const ImVec2 pixel{std::floor(corner.x), std::floor(corner.y)};
        const int first = list_->VtxBuffer.Size;
        // Letters are left out by where they are before they are turned.
        list_->PushClipRectFullScreen();
        list_->AddText(font, font_height(font), pixel, imgui_packed(context_.theme.text), label.c_str());
        list_->PopClipRect();
        if (axis_ == RulerAxis::y) turn(first, pixel);
    }

    /// Turns what was drawn since by a quarter counterclockwise.
    void turn(int first, ImVec2 center) {
        for (int i = first; i < list_->VtxBuffer.Size; ++i) {
            ImVec2& place = list_->VtxBuffer[i].pos;
            place = {center.x + (place.y - center.y), center.y - (place.x - center.x)};
        }
    }

    void draw_mark(double place) {
        const double half = context_.px(0.5 * mark_size);
        list_->AddTriangleFilled(at(place - half, context_.px(mark_size)), at(place, 0.0),
                                 at(place + half, context_.px(mark_size)), imgui_packed(context_.theme.accent));
        list_->AddLine(at(place, 0.0), at(place, width()), imgui_packed(context_.theme.accent), context_.px(1));
    }

    const PanelContext& context_;
    ImDrawList* list_;
    RulerAxis axis_;
    const Rectangle& rulers_;
    const Rectangle& canvas_;
};

void fill(const PanelContext& context, glm::dvec2 low, glm::dvec2 high) {
    ImGui::GetBackgroundDrawList()->AddRectFilled({static_cast<float>(low.x), static_cast<float>(low.y)},
                                                  {static_cast<float>(high.x), static_cast<float>(high.y)},
                                                  imgui_packed(context.theme.panel));
}

}  // namespace

void draw_rulers(const PanelContext& context, const Rectangle& rulers, const Rectangle& canvas) {
    if (rulers.size_px.x <= 0.0) return;
    const glm::dvec2 end = rulers.origin_px + rulers.size_px;
    fill(context, rulers.origin_px, {end.x, canvas.origin_px.y});
    fill(context, rulers.origin_px, {canvas.origin_px.x, end.y});
    for (const RulerAxis axis : {RulerAxis::x, RulerAxis::y}) RulerPainter(context, axis, rulers, canvas).draw();
    const glm::dvec2 middle = 0.5 * (rulers.origin_px + canvas.origin_px);
    const std::string unit = editor::ruler_corner(context.state);
    const glm::vec2 size = lines_size(unit, context.fonts.small);
    ImGui::GetBackgroundDrawList()->AddText(context.fonts.small, font_height(context.fonts.small),
                                            {std::floor(static_cast<float>(middle.x) - 0.5F * size.x),
                                             std::floor(static_cast<float>(middle.y) - 0.5F * size.y)},
                                            imgui_packed(context.theme.dim), unit.c_str());
    context.widgets.push_back(
        {"ruler x",
         {{canvas.origin_px.x, rulers.origin_px.y}, {canvas.size_px.x, canvas.origin_px.y - rulers.origin_px.y}},
         unit});
    context.widgets.push_back(
        {"ruler y",
         {{rulers.origin_px.x, canvas.origin_px.y}, {canvas.origin_px.x - rulers.origin_px.x, canvas.size_px.y}},
         unit});
}

}  // namespace batten::ui
