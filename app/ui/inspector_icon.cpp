#include <imgui.h>

#include <array>

#include "app/ui/inspector_widgets.h"
#include "app/ui/style.h"

namespace batten::ui {
namespace {

/// Draws in a square of 14 design pixels around a center.
struct Pen {
    const PanelContext& context;
    ImDrawList* list;
    ImVec2 center;
    ImU32 color;

    ImVec2 at(double x, double y) const { return {center.x + context.px(x), center.y + context.px(y)}; }
    float line() const { return context.px(1.4); }

    void stroke(ImVec2 a, ImVec2 b) const { list->AddLine(a, b, color, line()); }
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const { list->AddTriangleFilled(a, b, c, color); }
};

void draw_pause(const Pen& pen) {
    pen.list->AddRectFilled(pen.at(-4, -4.5), pen.at(-1, 4.5), pen.color);
    pen.list->AddRectFilled(pen.at(1, -4.5), pen.at(4, 4.5), pen.color);
}

void draw_ping_pong(const Pen& pen) {
    pen.stroke(pen.at(-4, 0), pen.at(4, 0));
    pen.triangle(pen.at(-7, 0), pen.at(-3, -3), pen.at(-3, 3));
    pen.triangle(pen.at(7, 0), pen.at(3, 3), pen.at(3, -3));
}

void draw_jump_back(const Pen& pen) {
    pen.stroke(pen.at(-6, 0), pen.at(2, 0));
    pen.triangle(pen.at(5, 0), pen.at(1, 3), pen.at(1, -3));
    pen.stroke(pen.at(6.5, -4), pen.at(6.5, 4));
}

void draw_lid(const Pen& pen, double height) {
    pen.list->AddBezierCubic(pen.at(-7, 0), pen.at(-3.5, height), pen.at(3.5, height), pen.at(7, 0), pen.color,
                             pen.line());
}

void draw_eye(const Pen& pen) {
    draw_lid(pen, -6);
    draw_lid(pen, 6);
    pen.list->AddCircleFilled(pen.center, pen.context.px(2.2), pen.color);
}

void draw_closed_eye(const Pen& pen) {
    draw_lid(pen, 5);
    pen.stroke(pen.at(-4.5, 3), pen.at(-5.8, 5.2));
    pen.stroke(pen.at(0, 3.9), pen.at(0, 6.4));
    pen.stroke(pen.at(4.5, 3), pen.at(5.8, 5.2));
}

void draw_lock(const Pen& pen, double shift) {
    pen.list->AddRectFilled(pen.at(-4.5, -0.5), pen.at(4.5, 6), pen.color, pen.context.px(1.5));
    const std::array points{pen.at(-2.8 + shift, -0.5), pen.at(-2.8 + shift, -3.4), pen.at(-1.4 + shift, -5.2),
                            pen.at(1.4 + shift, -5.2),  pen.at(2.8 + shift, -3.4),  pen.at(2.8 + shift, -0.5)};
    pen.list->AddPolyline(points.data(), static_cast<int>(points.size()), pen.color, 0, pen.line());
}

}  // namespace

void draw_icon(const PanelContext& context, ImVec2 center, Icon icon, render::Color color) {
    const Pen pen{context, ImGui::GetWindowDrawList(), center, imgui_packed(color)};
    switch (icon) {
        case Icon::none:
            return;
        case Icon::play:
            return pen.triangle(pen.at(-3.5, -5), pen.at(5, 0), pen.at(-3.5, 5));
        case Icon::pause:
            return draw_pause(pen);
        case Icon::ping_pong:
            return draw_ping_pong(pen);
        case Icon::jump_back:
            return draw_jump_back(pen);
        case Icon::eye:
            return draw_eye(pen);
        case Icon::closed_eye:
            return draw_closed_eye(pen);
        case Icon::lock:
            return draw_lock(pen, 0.0);
        case Icon::open_lock:
            return draw_lock(pen, 5.6);
        case Icon::plus:
            pen.stroke(pen.at(0, -4), pen.at(0, 4));
            return pen.stroke(pen.at(-4, 0), pen.at(4, 0));
        case Icon::minus:
            return pen.stroke(pen.at(-4, 0), pen.at(4, 0));
    }
}

}  // namespace batten::ui
