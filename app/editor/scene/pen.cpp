#include "app/editor/scene/pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <utility>

#include "app/editor/scene/text_size.h"
#include "render/clip.h"

namespace batten::editor {

namespace {

constexpr double margin_px = 64.0;
constexpr double longest_phase_px = 1e13;  // beyond it doubles no longer tell where in a dash a place is

render::Pixel pixel(glm::dvec2 place) {
    return render::Pixel(place);
}

float narrowed(double value) {
    return static_cast<float>(value);
}

/// A fraction of the way from a to b, computed from the nearer end, so that it is exact near both.
glm::dvec2 between(glm::dvec2 a, glm::dvec2 b, double t) {
    return t <= 0.5 ? a + t * (b - a) : b - (1.0 - t) * (b - a);
}

/// About where a text stands, as its anchor says.
render::PixelBox box_of(const render::Label& label) {
    const glm::dvec2 size = text_size(label.text, label.size_px, label.font);
    const double before = label.anchor == render::Anchor::left     ? 0.0
                          : label.anchor == render::Anchor::center ? 0.5
                                                                   : 1.0;
    const glm::dvec2 lower(label.position.x - before * size.x, label.position.y - 0.5 * size.y);
    return {lower, lower + size};
}

/// The pieces of a line that lie in `reach`, each as one command like `style`.
class LineCutter {
  public:
    LineCutter(render::DrawList& list, const render::PixelBox& reach, render::Polyline style, double along_px)
        : list_(list),
          reach_(reach),
          style_(std::move(style)),
          period_(style_.dash_px + style_.gap_px),
          along_(along_px),
          least_t_(along_px > 0.0 ? -std::numeric_limits<double>::infinity() : 0.0) {}

    void add(glm::dvec2 a, glm::dvec2 b) {
        const double length = glm::distance(a, b);
        const auto part = render::clip_segment(reach_, a, b);
        if (part) {
            if (run_.empty() || part->first > 0.0) begin(a, b, part->first, length);
            run_.push_back(pixel(glm::clamp(between(a, b, part->last), reach_.lower_px, reach_.upper_px)));
        }
        if (!part || part->last < 1.0) end();
        along_ += length;
    }

    void end() {
        if (run_.size() > 1) {
            style_.points = std::exchange(run_, {});
            list_.add(style_);
        }
        run_.clear();
    }

  private:
    void begin(glm::dvec2 a, glm::dvec2 b, double t, double length) {
        end();
        // A whole number of periods from the line's first point, so that dashes keep their places while the view moves.
        const double along = along_ + t * length;
        if (period_ > 0.0 && length > 0.0 && along < longest_phase_px)
            t = std::max(least_t_, t - std::fmod(along, period_) / length);
        least_t_ = 0.0;
        // Between ends that are very far away the place is known only roughly.
        const glm::dvec2 place = between(a, b, t);
        run_.push_back(pixel(glm::clamp(place, reach_.lower_px - period_, reach_.upper_px + period_)));
    }

    render::DrawList& list_;
    const render::PixelBox& reach_;
    render::Polyline style_;
    double period_;
    double along_;
    double least_t_;  // a line that goes on from before its first point may begin there
    std::vector<render::Pixel> run_;
};

}  // namespace

Pen::Pen(render::DrawList& list, glm::dvec2 size_px, double scale, const Notation& notation)
    : list_(list),
      size_px_(size_px),
      scale_(scale),
      reach_{glm::dvec2(-margin_px * scale), size_px + glm::dvec2(margin_px * scale)},
      notation_(notation) {}

Pen Pen::within(const render::PixelBox& box) const {
    Pen pen = *this;
    pen.reach_ = box;
    return pen;
}

void Pen::line(std::span<const glm::dvec2> points, const Stroke& stroke, double along_px) {
    render::Polyline style{.points = {},
                           .color = stroke.color,
                           .width_px = narrowed(px(stroke.width)),
                           .dash_px = narrowed(px(stroke.dash)),
                           .gap_px = narrowed(px(stroke.gap)),
                           .is_closed = false};
    LineCutter cutter(list_, reach_, std::move(style), along_px);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) cutter.add(points[i], points[i + 1]);
    cutter.end();
}

void Pen::segment(glm::dvec2 a, glm::dvec2 b, const Stroke& stroke) {
    line(std::array{a, b}, stroke);
}

void Pen::outline(std::vector<glm::dvec2> points, const Stroke& stroke) {
    if (points.empty()) return;
    points.push_back(points.front());
    line(points, stroke);
}

void Pen::fill(std::vector<glm::dvec2> polygon, render::Color color) {
    polygon = render::clip_polygon(reach_, std::move(polygon));
    if (polygon.size() < 3) return;
    render::Fill fill{{}, color};
    fill.points.reserve(polygon.size());
    for (const glm::dvec2 point : polygon) fill.points.push_back(pixel(point));
    list_.add(std::move(fill));
}

void Pen::ink(std::shared_ptr<const render::CoverageMap> map, render::Color color) {
    list_.add(render::Ink{std::move(map), color});
}

void Pen::region(const render::Region& region) {
    list_.add(region);
}

void Pen::symbol(glm::dvec2 center, const Symbol& symbol) {
    if (!reach_.contains(center)) return;
    list_.add(render::Marker{.center = pixel(center),
                             .shape = symbol.shape,
                             .radius_px = narrowed(px(symbol.radius)),
                             .fill = symbol.fill,
                             .outline = symbol.outline,
                             .outline_px = narrowed(px(symbol.outline_width)),
                             .dash_px = narrowed(px(symbol.dash))});
}

void Pen::text(glm::dvec2 position, const std::string& text, const TextStyle& style) {
    if (!reach_.contains(position)) return;
    list_.add(render::Label{.position = pixel(position),
                            .text = notated(text, notation_),
                            .color = style.color,
                            .size_px = narrowed(px(style.size)),
                            .anchor = style.anchor,
                            .font = style.font,
                            .gap_px = narrowed(px(style.gap))});
}

void Pen::clear_texts(const render::PixelBox& box) {
    std::erase_if(list_.commands, [&](const render::DrawCommand& command) {
        const auto* label = std::get_if<render::Label>(&command);
        return label != nullptr && box_of(*label).overlaps(box);
    });
}

std::vector<glm::dvec2> rounded_rectangle(const render::PixelBox& box, double radius_px) {
    constexpr int steps = 4;
    const std::array centers{glm::dvec2(box.upper_px.x - radius_px, box.upper_px.y - radius_px),
                             glm::dvec2(box.lower_px.x + radius_px, box.upper_px.y - radius_px),
                             glm::dvec2(box.lower_px.x + radius_px, box.lower_px.y + radius_px),
                             glm::dvec2(box.upper_px.x - radius_px, box.lower_px.y + radius_px)};
    std::vector<glm::dvec2> points;
    for (std::size_t corner = 0; corner < centers.size(); ++corner)
        for (int k = 0; k <= steps; ++k) {
            const double angle =
                0.5 * std::numbers::pi * (static_cast<double>(corner) + static_cast<double>(k) / steps);
            points.push_back(centers[corner] + radius_px * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
    return points;
}

std::vector<glm::dvec2> corners_of(const render::PixelBox& box) {
    return {box.lower_px, {box.upper_px.x, box.lower_px.y}, box.upper_px, {box.lower_px.x, box.upper_px.y}};
}

}  // namespace batten::editor
