#include "app/editor/scene/shape_at_parameter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/editor/cards/card_texts.h"
#include "app/editor/scene/arrow.h"
#include "core/evaluate/tangent.h"
#include "core/measure/curvature.h"

namespace batten::editor {

namespace {

constexpr double arrow_length = 84.0;
constexpr double tangent_reach = 170.0;
constexpr double name_height = 14.0;
constexpr double sagitta_px = 0.15;  // how far the polygon of the circle may be off it
constexpr double most_circle_steps = 400.0;
constexpr double same_circle = 1e-9;  // relative difference of equal curvatures

glm::dvec2 in_picture(core::Vector direction) {
    return {direction.x, -direction.y};
}

/// As much of the circle through C(u) as may be in the picture, whatever its size.
std::vector<glm::dvec2> arc_places(const CanvasFrame& frame, const core::OsculatingCircle& circle) {
    const glm::dvec2 contact = frame.screen(frame.triangle->point());
    const core::Vector inward = circle.center - frame.triangle->point();
    const glm::dvec2 normal = in_picture(inward / core::robust_length(inward));
    const glm::dvec2 along{normal.y, -normal.x};
    const double radius = circle.radius * frame.state.view.camera.scale;
    const glm::dvec2 picture = frame.pen.size_px();
    const double reach = glm::length(picture) + glm::distance(contact, 0.5 * picture);
    const double half = std::min(std::numbers::pi, 3.0 * reach / radius);
    const double steps =
        std::clamp(std::ceil(half / std::sqrt(2.0 * sagitta_px / std::max(radius, 1.0))), 8.0, most_circle_steps) *
        frame.state.view.parts.fineness;
    std::vector<glm::dvec2> places;
    for (double k = -steps; k <= steps; k += 1.0) {
        const double angle = half * k / steps;
        const double rise = 2.0 * std::pow(std::sin(0.5 * angle), 2);  // 1 - cos
        places.push_back(contact + radius * (std::sin(angle) * along + rise * normal));
    }
    return places;
}

bool is_near_picture(const CanvasFrame& frame) {
    const glm::dvec2 contact = frame.screen(frame.triangle->point());
    return glm::distance(contact, 0.5 * frame.pen.size_px()) <= 4.0 * glm::length(frame.pen.size_px());
}

void draw_radius(CanvasFrame& frame, const core::OsculatingCircle& circle) {
    const glm::dvec2 contact = frame.screen(frame.triangle->point());
    const glm::dvec2 center = frame.screen(circle.center);
    frame.pen.segment(contact, center, {.color = frame.theme.comb, .width = 1.5, .dash = 5.0, .gap = 4.0});
    frame.pen.symbol(center,
                     {.radius = 4.0, .fill = frame.theme.comb, .outline = frame.theme.canvas, .outline_width = 1.5});
    const Units& units = frame.state.shown().units;
    const std::string radius = with_unit(units, short_text(frame.state.view.notation, in_units(units, circle.radius)));
    const std::string text = fmt::format("ρ = {}", radius);
    frame.labels.push_back({.place = center,
                            .words = {{text, {.color = frame.theme.text, .size = name_height}}},
                            .distance = 10.0,
                            .crowding = Crowding::cover_symbols,
                            .farthest = 40.0,
                            .has_ground = true});
}

/// That from the left, where it is another one.
std::optional<core::OsculatingCircle> circle_from_left(const CanvasFrame& frame,
                                                       const std::optional<core::OsculatingCircle>& right) {
    const double u = frame.triangle->u;
    if (frame.curve->knots().multiplicity(u) == 0) return std::nullopt;
    const auto left = core::osculating_circle(*frame.curve, u, core::Side::left);
    if (!left || !right) return left;
    const double apart = core::distance(left->center, right->center);
    return apart > same_circle * std::max(left->radius, right->radius) ? left : std::nullopt;
}

void draw_named_arrow(CanvasFrame& frame, glm::dvec2 from, glm::dvec2 along, const char* name, const Stroke& stroke) {
    const glm::dvec2 tip = from + frame.pen.px(arrow_length) * along;
    frame.keep_free(from + 0.25 * (tip - from), tip, 4.0);
    draw_arrow(frame.pen, from, tip, stroke);
    frame.labels.push_back(
        {.place = tip,
         .words = {{name, {.color = frame.theme.text, .size = name_height, .font = render::LabelFont::bold}}},
         .distance = 8.0,
         .crowding = Crowding::cover_symbols});
}

void draw_line_along(CanvasFrame& frame, glm::dvec2 from, glm::dvec2 along, double dash) {
    const glm::dvec2 reach = frame.pen.px(tangent_reach) * along;
    frame.pen.segment(from - reach, from + reach,
                      {.color = frame.theme.level(1), .width = 1.5, .dash = dash, .gap = dash});
}

}  // namespace

void draw_osculating_circle(CanvasFrame& frame) {
    const auto circle = core::osculating_circle(*frame.curve, frame.triangle->u);
    if (!is_near_picture(frame)) return;
    if (const auto left = circle_from_left(frame, circle))
        frame.pen.line(arc_places(frame, *left), {.color = frame.theme.comb, .width = 1.75, .dash = 7.0, .gap = 5.0});
    if (!circle) return;
    frame.pen.line(arc_places(frame, *circle), {.color = frame.theme.comb, .width = 2.0});
    draw_radius(frame, *circle);
}

void draw_tangent_and_normal(CanvasFrame& frame) {
    const double u = frame.triangle->u;
    const glm::dvec2 place = frame.screen(frame.triangle->point());
    const auto left = core::tangent_at(*frame.curve, u, core::Side::left);
    const auto tangent = core::tangent_at(*frame.curve, u);
    constexpr double corner = 1e-9;
    if (left && tangent && core::length(*left - *tangent) > corner)
        draw_line_along(frame, place, in_picture(*left), 6.0);
    if (!tangent) return;
    const glm::dvec2 along = in_picture(*tangent);
    draw_line_along(frame, place, along, 0.0);
    draw_named_arrow(frame, place, along, "T", {.color = frame.theme.level(1), .width = 3.0});
    draw_named_arrow(frame, place, in_picture(core::turned_left(*tangent)), "N",
                     {.color = frame.theme.level(2), .width = 3.0});
}

}  // namespace batten::editor
