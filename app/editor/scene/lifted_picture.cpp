#include "app/editor/scene/lifted_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/scene/curve_strokes.h"
#include "app/editor/scene/label_layout.h"
#include "app/editor/scene/panel_box.h"
#include "app/editor/scene/text_size.h"
#include "core/evaluate/farin_points.h"

namespace batten::editor {

namespace {

constexpr double plane_opacity = 0.35;
constexpr double generator_share = 0.4;
constexpr double ray_share = 0.55;
constexpr double ray_beyond = 1.06;  // of the way to what is higher
constexpr std::size_t generator_count = 32;
constexpr double steps_of_bent_leg = 12.0;
constexpr double lifted_tolerance = 1e-3;  // in space
constexpr double lifted_width = 3.0;
constexpr double lifted_title_height = 24.0;
constexpr double lifted_padding = 12.0;
constexpr double shadow_width = 2.25;
constexpr double lifted_name_size = 13.0;
constexpr double lifted_name_distance = 9.0;
constexpr double lifted_name_farthest = 27.0;
constexpr double lifted_name_step = 6.0;
constexpr double lifted_name_reach = 7.0;
constexpr double plane_name_size = 12.0;
constexpr double shadow_reach = 4.0;

/// What is drawn beside the curve, its shadow and the plane.
struct LiftedParts {
    bool polygon = true;
    bool points = true;
    bool names = false;
};

/// One picture while it is drawn.
class LiftedPicture {
  public:
    LiftedPicture(CanvasFrame& frame, const render::PixelBox& box, const LiftedParts& parts)
        : frame_(frame),
          parts_(parts),
          stage_(lifted_stage(frame.state, box)),
          pen_(frame.pen.within({box.lower_px + glm::dvec2(0.0, frame.pen.px(lifted_title_height)), box.upper_px})),
          samples_(frame.kept->lifted(stage_.view, {.tolerance = lifted_tolerance / std::pow(fineness(), 2)})),
          is_from_above_(stage_.camera.pitch >= 0.0) {}

    void draw() {
        draw_generators();
        draw_side(!is_from_above_);
        draw_plane();
        draw_shadow();
        draw_side(is_from_above_);
        draw_origin();
        if (parts_.points) draw_points();
        draw_labels();
        if (frame_.state.view.parts.parameter) draw_parameter();
        draw_hovered_place();
    }

  private:
    double fineness() const { return frame_.state.view.parts.fineness; }
    std::span<const core::Point> points() const { return frame_.curve->control_points(); }
    double weight(std::size_t i) const { return frame_.curve->weights()[i]; }
    glm::dvec2 origin() const { return render::screen_from_space(stage_.camera, {0.0, 0.0, 0.0}); }
    glm::dvec2 shown(core::Point shadow, double weight) const { return stage_.screen(shadow, weight); }

    template <class Visit>
    void for_each_point(const Visit& visit) const {
        for (std::size_t i = 0; i < points().size(); i += lifted_stride(*frame_.curve)) visit(i);
    }

    /// Where the polygon is shown.
    template <class Visit>
    void for_each_leg(const Visit& visit) const {
        if (!parts_.polygon || lifted_stride(*frame_.curve) > 1) return;
        for (std::size_t leg = 0; leg < core::leg_count(*frame_.curve); ++leg) visit(leg_samples(leg));
    }

    /// From the origin to the shadow or beyond it to the lifted point.
    void draw_ray(core::Point shadow, double weight, render::Color color, double width) {
        const double height = std::max(1.0, std::pow(weight, stage_.view.exponent));
        const glm::dvec3 end = ray_beyond * height * stage_.view.place(shadow);
        pen_.segment(origin(), render::screen_from_space(stage_.camera, end), {.color = color, .width = width});
    }

    /// Rays through points of the curve, evenly spread, which make the cone over it.
    void draw_generators() {
        const render::Color color = render::blended(frame_.theme.dim, generator_share, frame_.theme.panel);
        for (const auto& run : samples_)
            for (std::size_t k = 0; k <= generator_count; ++k) {
                const core::LiftedSample& sample = run[k * (run.size() - 1) / generator_count];
                draw_ray(sample.point, sample.weight, color, 1.0);
            }
    }

    /// The polygon and the curve in space as far as they are above, or else below the plane.
    void draw_side(bool is_above) {
        const Stroke polygon{.color = frame_.theme.polygon, .width = 1.5, .dash = 6.0, .gap = 5.0};
        for_each_leg([&](const std::vector<core::LiftedSample>& leg) { draw_on_side(leg, is_above, polygon); });
        const Stroke lifted{.color = frame_.theme.level(2), .width = lifted_width};
        for (const auto& run : samples_) draw_on_side(run, is_above, lifted);
    }

    /// A leg, which is straight one dimension up.
    std::vector<core::LiftedSample> leg_samples(std::size_t leg) const {
        const std::size_t next = (leg + 1) % points().size();
        std::vector<core::LiftedSample> samples;
        const auto steps = static_cast<int>(steps_of_bent_leg * fineness());
        for (int k = 0; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            // Parts of the larger weight: no quotient or product is larger than what it is made of.
            const double larger = std::max(weight(leg), weight(next));
            const double pull = (1.0 - t) * (weight(leg) / larger);
            const double pull_of_next = t * (weight(next) / larger);
            const double sum = pull + pull_of_next;
            const double share = sum > 0.0 ? pull_of_next / sum : t;
            const core::Vector place =
                (1.0 - share) * core::vector_to(points()[leg]) + share * core::vector_to(points()[next]);
            samples.push_back({t, core::tip_of(place), (1.0 - t) * weight(leg) + t * weight(next)});
        }
        return samples;
    }

    void draw_on_side(const std::vector<core::LiftedSample>& run, bool is_above, const Stroke& stroke) {
        std::vector<glm::dvec2> line;
        const auto end_line = [&] {
            if (line.size() > 1) pen_.line(line, stroke);
            line.clear();
        };
        for (std::size_t i = 0; i + 1 < run.size(); ++i) {
            const bool belongs = (0.5 * (run[i].weight + run[i + 1].weight) >= 1.0) == is_above;
            if (!belongs) {
                end_line();
                continue;
            }
            if (line.empty()) line.push_back(shown(run[i].point, run[i].weight));
            line.push_back(shown(run[i + 1].point, run[i + 1].weight));
        }
        end_line();
    }

    std::vector<glm::dvec2> plane_corners() const {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec3& corner : stage_.plane)
            corners.push_back(render::screen_from_space(stage_.camera, corner));
        return corners;
    }

    void draw_plane() {
        const std::vector<glm::dvec2> corners = plane_corners();
        pen_.fill(corners, render::faded(frame_.theme.field, plane_opacity));
        pen_.outline(corners, {.color = frame_.theme.dim});
    }

    void draw_shadow() {
        const Stroke polygon{.color = frame_.theme.polygon, .width = 1.0, .dash = 3.0, .gap = 3.0};
        std::vector<glm::dvec2> line;
        for_each_point([&](std::size_t i) { line.push_back(shown(points()[i], 1.0)); });
        if (frame_.curve->is_periodic()) line.push_back(line.front());
        if (parts_.polygon) pen_.line(line, polygon);
        const render::Color color = color_of(*frame_.state.shown().active_curve(), frame_.theme);
        for (const auto& run : samples_) {
            std::vector<glm::dvec2> curve;
            for (const core::LiftedSample& sample : run) curve.push_back(shown(sample.point, 1.0));
            pen_.line(curve, {.color = color, .width = shadow_width});
        }
    }

    void draw_origin() {
        pen_.text(origin() + glm::dvec2(pen_.px(8.0), 0.0), "O", {.color = frame_.theme.dim, .size = 13.0});
        pen_.symbol(origin(), {.radius = 3.5, .fill = frame_.theme.text, .outline = no_color});
    }

    void draw_points() {
        for_each_point([&](std::size_t i) {
            draw_ray(points()[i], weight(i),
                     render::blended(frame_.theme.point(frame_.hue(i)), ray_share, frame_.theme.panel), 1.25);
        });
        const auto* hovered = std::get_if<HoveredPoint>(&frame_.state.hover);
        const auto* lifted = std::get_if<HoveredLifted>(&frame_.state.hover);
        for_each_point([&](std::size_t i) {
            const render::Color color = frame_.theme.point(frame_.hue(i));
            pen_.symbol(shown(points()[i], 1.0),
                        {.radius = 3.0, .fill = frame_.theme.panel, .outline = color, .outline_width = 1.5});
            const bool is_large =
                (hovered != nullptr && hovered->index == i) || (lifted != nullptr && lifted->index == i);
            pen_.symbol(
                shown(points()[i], weight(i)),
                {.radius = is_large ? 8.0 : 6.0, .fill = color, .outline = frame_.theme.panel, .outline_width = 2.0});
        });
    }

    /// What the plane is called, and the names beside the lifted points, off the curves and what else has a name.
    void draw_labels() {
        LabelLayout layout(frame_.pen.size_px());
        const glm::dvec2 reach(pen_.px(lifted_name_reach));
        for (const auto& run : samples_)
            for (const bool is_lifted : {true, false}) {
                std::vector<glm::dvec2> line;
                for (const core::LiftedSample& sample : run)
                    line.push_back(shown(sample.point, is_lifted ? sample.weight : 1.0));
                layout.avoid_line(line);
            }
        for_each_leg([&](const std::vector<core::LiftedSample>& leg) {
            std::vector<glm::dvec2> line;
            for (const core::LiftedSample& sample : leg) line.push_back(shown(sample.point, sample.weight));
            layout.avoid_line(line);
        });
        layout.avoid_box({origin() - reach, origin() + 3.0 * reach});
        if (parts_.points)
            for_each_point([&](std::size_t i) {
                const glm::dvec2 place = shown(points()[i], weight(i));
                layout.avoid_box({place - reach, place + reach});
                layout.avoid_symbol(shown(points()[i], 1.0), pen_.px(shadow_reach));
            });
        write_plane_name(layout);
        if (!parts_.names) return;
        std::vector<glm::dvec2> plane = plane_corners();
        plane.push_back(plane.front());
        layout.avoid_line(plane);
        draw_names(layout);
    }

    /// At the highest corner where it covers nothing, else at the highest.
    void write_plane_name(LabelLayout& layout) {
        std::vector<glm::dvec2> corners = plane_corners();
        std::ranges::sort(corners, {}, [](glm::dvec2 corner) { return corner.y; });
        const glm::dvec2 size = text_size("w = 1", pen_.px(plane_name_size), render::LabelFont::text);
        for (const Crowding crowding : {Crowding::cover_nothing, Crowding::cover_symbols})
            for (const glm::dvec2 corner : corners)
                if (const auto place = layout.place(corner, size, pen_.px(1.5), LabelSide::above, crowding)) {
                    pen_.text(place->position, "w = 1",
                              {.color = frame_.theme.dim, .size = plane_name_size, .anchor = place->anchor});
                    return;
                }
        frame_.cache.unplaced().emplace_back("w = 1");
    }

    void draw_names(LabelLayout& layout) {
        for_each_point([&](std::size_t i) {
            const std::string name = fmt::format("P_{{{}}}", i);
            if (!write_name(layout, shown(points()[i], weight(i)), name)) frame_.cache.unplaced().push_back(name);
        });
    }

    bool write_name(LabelLayout& layout, glm::dvec2 point, const std::string& name) {
        const glm::dvec2 size = text_size(name, pen_.px(lifted_name_size), render::LabelFont::text);
        for (const Crowding crowding : {Crowding::cover_nothing, Crowding::leave_out, Crowding::cover_symbols})
            for (double distance = lifted_name_distance; distance <= lifted_name_farthest; distance += lifted_name_step)
                if (const auto place = layout.place(point, size, pen_.px(distance), LabelSide::upper_right, crowding)) {
                    pen_.text(place->position, name,
                              {.color = frame_.theme.text, .size = lifted_name_size, .anchor = place->anchor});
                    return true;
                }
        return false;
    }

    void draw_parameter() {
        const core::DeBoorCell& last = frame_.triangle->levels.back().front();
        draw_ray(last.point, last.weight, frame_.theme.parameter, 1.75);
        pen_.symbol(
            shown(last.point, 1.0),
            {.radius = 4.0, .fill = frame_.theme.panel, .outline = frame_.theme.parameter, .outline_width = 2.0});
        pen_.symbol(
            shown(last.point, last.weight),
            {.radius = 5.5, .fill = frame_.theme.parameter, .outline = frame_.theme.panel, .outline_width = 1.5});
    }

    /// On the lifted curve and on its shadow.
    void draw_hovered_place() {
        const auto u = hovered_u(frame_.state.hover);
        if (!u) return;
        const core::LiftedSample there = core::lifted_at(*frame_.curve, *u);
        if (!core::is_finite(there.point) || !std::isfinite(there.weight)) return;
        for (const double weight : {1.0, there.weight})
            pen_.symbol(shown(there.point, weight), hovered_place_symbol(frame_.theme));
    }

    CanvasFrame& frame_;
    LiftedParts parts_;
    LiftedStage stage_;
    Pen pen_;
    const std::vector<std::vector<core::LiftedSample>>& samples_;
    bool is_from_above_;
};

}  // namespace

void draw_lifted_picture(CanvasFrame& frame, const render::PixelBox& box) {
    draw_panel_box(frame.pen, frame.theme, box);
    const glm::dvec2 padding(frame.pen.px(lifted_padding));
    frame.pen.text(box.lower_px + padding + glm::dvec2(0.0, frame.pen.px(2.0)), "Homogeneous view",
                   {.color = frame.theme.dim, .size = 12.0});
    LiftedPicture(frame, box, {}).draw();
}

void draw_lifted_curve(CanvasFrame& frame, const render::PixelBox& box) {
    const LiftedParts parts{.polygon = frame.shows(Overlay::polygon),
                            .points = frame.state.view.parts.points,
                            .names = frame.shows(Overlay::labels)};
    // Where the title of an inset is there is room.
    const glm::dvec2 title(0.0, frame.pen.px(lifted_title_height));
    LiftedPicture(frame, {box.lower_px - title, box.upper_px}, parts).draw();
}

}  // namespace batten::editor
