#include "app/ui/picture_item.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <vector>

#include "app/ui/labels.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

class PicturePainter {
  public:
    PicturePainter(ImDrawList* list, glm::vec2 corner_px, const Fonts& fonts)
        : list_(list), corner_(corner_px), fonts_(fonts) {}

    void operator()(const render::Polyline& line) const {
        if (line.dash_px > 0.0F) return draw_dashed(line);
        const std::vector<ImVec2> points = placed(line.points);
        const ImDrawFlags flags = line.is_closed ? ImDrawFlags_Closed : ImDrawFlags_None;
        list_->AddPolyline(points.data(), static_cast<int>(points.size()), imgui_packed(line.color), flags,
                           line.width_px);
    }

    void operator()(const render::Fill& fill) const {
        const std::vector<ImVec2> points = placed(fill.points);
        list_->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), imgui_packed(fill.color));
    }

    void operator()(const render::Ink&) const {}

    void operator()(const render::Region&) const {}
    void operator()(const render::ImageQuad&) const {}

    void operator()(const render::Marker& marker) const {
        const std::vector<ImVec2> points = outline_of(marker);
        const int count = static_cast<int>(points.size());
        list_->AddConvexPolyFilled(points.data(), count, imgui_packed(marker.fill));
        if (marker.outline_px > 0.0F)
            list_->AddPolyline(points.data(), count, imgui_packed(marker.outline), ImDrawFlags_Closed,
                               marker.outline_px);
    }

    void operator()(const render::Label& label) const { draw_label(list_, label, corner_, fonts_); }

  private:
    ImVec2 placed(render::Pixel pixel) const { return {corner_.x + pixel.x, corner_.y + pixel.y}; }

    std::vector<ImVec2> placed(const std::vector<render::Pixel>& pixels) const {
        std::vector<ImVec2> points;
        points.reserve(pixels.size());
        for (const render::Pixel pixel : pixels) points.push_back(placed(pixel));
        return points;
    }

    std::vector<ImVec2> outline_of(const render::Marker& marker) const {
        const ImVec2 c = placed(marker.center);
        const float r = marker.radius_px;
        switch (marker.shape) {
            case render::MarkerShape::square:
                return {{c.x - r, c.y - r}, {c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}};
            case render::MarkerShape::diamond:
                return {{c.x - r, c.y}, {c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}};
            case render::MarkerShape::disc:
                break;
        }
        constexpr int corners = 24;
        std::vector<ImVec2> points;
        for (int i = 0; i < corners; ++i) {
            const float angle = 2.0F * static_cast<float>(M_PI) * static_cast<float>(i) / corners;
            points.emplace_back(c.x + r * std::cos(angle), c.y + r * std::sin(angle));
        }
        return points;
    }

    void draw_dashed(const render::Polyline& line) const {
        float along = 0.0F;  // of the dash or gap that is under way
        bool is_gap = false;
        const std::size_t legs = line.is_closed ? line.points.size() : line.points.size() - 1;
        for (std::size_t i = 0; i < legs; ++i) {
            const glm::vec2 a = line.points[i];
            const glm::vec2 leg = line.points[(i + 1) % line.points.size()] - a;
            const float length = std::sqrt(leg.x * leg.x + leg.y * leg.y);
            for (float at = 0.0F; at < length;) {
                const float left = std::max((is_gap ? line.gap_px : line.dash_px) - along, 0.01F);
                const float end = std::min(length, at + left);
                if (!is_gap)
                    list_->AddLine(placed(a + at / length * leg), placed(a + end / length * leg),
                                   imgui_packed(line.color), line.width_px);
                const bool is_done = end - at >= left;
                along = is_done ? 0.0F : along + end - at;
                if (is_done) is_gap = !is_gap;
                at = end;
            }
        }
    }

    ImDrawList* list_;
    glm::vec2 corner_;
    const Fonts& fonts_;
};

}  // namespace

void draw_picture(ImDrawList* list, const render::DrawList& picture, glm::vec2 corner_px, const Fonts& fonts) {
    for (const render::DrawCommand& command : picture.commands)
        std::visit(PicturePainter(list, corner_px, fonts), command);
}

}  // namespace batten::ui
