#include "app/editor/scene/quantity_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/grid_step.h"
#include "app/editor/scene/bend_marks.h"
#include "app/editor/scene/text_row.h"
#include "app/editor/words/formula.h"

namespace batten::editor {

namespace {

constexpr double parameters_per_px = 0.5;  // of the picture's width
constexpr double quantity_title_height = 17.0;
constexpr double levels_in_grid = 5.0;  // how many times denser the numbers at the side are than those of the grid
constexpr double head_room = 0.06;      // of the values, above and below

/// One of the plots while it is drawn.
class QuantityPlot {
  public:
    QuantityPlot(PlotFrame& frame, core::Quantity quantity, render::PixelBox box)
        : frame_(frame), quantity_(quantity), box_(box) {
        box_.lower_px.y += frame.pen.px(quantity_title_height);
        const auto most =
            static_cast<std::size_t>(parameters_per_px * frame.state.view.parts.fineness * frame.pen.size_px().x) + 8;
        graph_ = frame.state.measured.graph(frame.curve, {quantity, frame.layout.range, most});
        const double length = graph_->values.length();
        const double room = length > 0.0 && std::isfinite(length) ? head_room * length : 1.0;
        values_ = {graph_->values.lower - room, graph_->values.upper + room};
    }

    void draw() {
        draw_ground();
        draw_levels();
        for (const core::GraphRun& run : graph_->runs) draw_run(run);
        if (quantity_ == core::Quantity::curvature && frame_.state.view.overlays.is_shown(Overlay::curvature_marks))
            draw_bends();
        draw_title();
        if (shows_parameter()) draw_at_parameter();
    }

  private:
    bool shows_parameter() const { return frame_.state.view.parts.parameter; }

    double y(double value) const {
        const double share = (value - values_.lower) / values_.length();
        return box_.upper_px.y - share * (box_.upper_px.y - box_.lower_px.y);
    }

    render::Color color() const {
        return quantity_ == core::Quantity::curvature ? frame_.theme.comb : frame_.theme.level(2);
    }

    void draw_ground() {
        const core::KnotVector& knots = frame_.curve.knots();
        auto span = frame_.band({knots[frame_.span], knots[frame_.span + 1]});
        if (span && shows_parameter()) {
            span->lower_px.y = box_.lower_px.y;
            span->upper_px.y = box_.upper_px.y;
            frame_.pen.fill(corners_of(*span), render::faded(frame_.theme.accent, 0.07));
        }
        frame_.pen.outline(corners_of(box_), {.color = render::blended(frame_.theme.line, 0.7, frame_.theme.panel)});
    }

    /// Curvatures are per unit of the document; speeds are of the parameter's world.
    double shown(double value) const {
        return quantity_ == core::Quantity::curvature ? in_units(frame_.state.shown().units, value, -1) : value;
    }

    void draw_levels() {
        const double height = (box_.upper_px.y - box_.lower_px.y) / frame_.pen.px(1.0);
        const double unit = shown(1.0);
        const double step = major_grid_step(levels_in_grid * height / (values_.length() * unit)) / unit;
        TextRow row;
        const double first = std::ceil(values_.lower / step);
        for (double k = first; k * step <= values_.upper && k < first + 20.0; k += 1.0) draw_level(row, k * step);
    }

    void draw_level(TextRow& row, double value) {
        const double left = frame_.layout.left_px;
        const bool is_zero = value == 0.0;
        frame_.pen.segment(
            {left, y(value)}, {frame_.layout.right_px, y(value)},
            {.color = is_zero ? frame_.theme.dim : render::blended(frame_.theme.line, 0.7, frame_.theme.panel)});
        // Not so high that it would run into the title.
        if (y(value) < box_.lower_px.y + frame_.pen.px(7.0)) return;
        row.write(frame_.pen, {left - frame_.pen.px(5.0), y(value)}, number_text(shown(value)),
                  {.color = frame_.theme.dim, .size = 11.0, .anchor = render::Anchor::right});
    }

    /// Only what is inside of the box: a pole leaves it upward and comes back from below.
    void draw_run(const core::GraphRun& run) {
        const Stroke stroke{.color = color(), .width = 2.25};
        std::vector<glm::dvec2> places;
        for (std::size_t k = 0; k + 1 < run.size(); ++k) {
            const auto [from, to] = shares_inside(run[k].value, run[k + 1].value);
            if (!(from <= to)) continue;
            const auto place = [&](double share) {
                return glm::dvec2(frame_.x(run[k].u + share * (run[k + 1].u - run[k].u)),
                                  y(run[k].value + share * (run[k + 1].value - run[k].value)));
            };
            if (from > 0.0 || places.empty()) {
                frame_.pen.line(places, stroke);
                places = {place(from)};
            }
            places.push_back(place(to));
        }
        frame_.pen.line(places, stroke);
        if (run.size() == 1)
            frame_.pen.symbol({frame_.x(run[0].u), y(run[0].value)},
                              {.radius = 1.5, .fill = color(), .outline = no_color});
    }

    /// The part of the way from one value to another that lies between the lowest and the highest.
    core::Interval shares_inside(double a, double b) const {
        core::Interval shares{0.0, 1.0};
        for (const double limit : {values_.lower, values_.upper}) {
            const bool is_lower = limit == values_.lower;
            const bool a_is_out = is_lower ? a < limit : a > limit;
            const bool b_is_out = is_lower ? b < limit : b > limit;
            if (a_is_out && b_is_out) return {1.0, 0.0};
            if (a_is_out) shares.lower = std::max(shares.lower, (limit - a) / (b - a));
            if (b_is_out) shares.upper = std::min(shares.upper, (limit - a) / (b - a));
        }
        return shares;
    }

    /// As on the curve: rings at inflections, squares at extremes.
    void draw_bends() {
        if (!is_searched_whole(frame_.curve)) return;
        const auto bends = frame_.state.measured.bends(frame_.curve, {frame_.curve.domain()});
        for (const core::CurvatureExtremum& extremum : bends->extrema)
            mark(extremum.u, extremum.curvature,
                 {.shape = render::MarkerShape::square,
                  .radius = 4.0,
                  .fill = color(),
                  .outline = frame_.theme.panel,
                  .outline_width = 1.5});
        for (const core::Inflection& inflection : bends->inflections)
            mark(inflection.u, 0.0,
                 {.radius = 4.5, .fill = frame_.theme.panel, .outline = color(), .outline_width = 2.0});
    }

    void mark(double u, double value, const Symbol& symbol) {
        if (frame_.layout.range.contains(u) && values_.contains(value))
            frame_.pen.symbol({frame_.x(u), y(value)}, symbol);
    }

    void draw_title() {
        const bool is_curvature = quantity_ == core::Quantity::curvature;
        const double height = box_.lower_px.y - frame_.pen.px(0.5 * quantity_title_height);
        frame_.pen.text({frame_.pen.px(16.0), height}, is_curvature ? "Curvature κ(u)" : "Speed |C′(u)|",
                        {.color = frame_.theme.text, .size = 12.5, .font = render::LabelFont::bold});
        if (!shows_parameter()) return;
        const auto value = core::quantity_at(frame_.curve, quantity_, frame_.u);
        const std::string number = value ? number_text(shown(*value)) : "none";
        frame_.pen.text({frame_.pen.size_px().x - frame_.pen.px(16.0), height},
                        is_curvature ? fmt::format("κ = {}", number) : fmt::format("|C′| = {}", number),
                        {.color = frame_.theme.parameter,
                         .size = 12.5,
                         .anchor = render::Anchor::right,
                         .font = render::LabelFont::bold});
    }

    void draw_at_parameter() {
        if (!frame_.layout.range.contains(frame_.u)) return;
        const double x = frame_.x(frame_.u);
        frame_.pen.segment({x, box_.lower_px.y}, {x, box_.upper_px.y}, {.color = frame_.theme.parameter, .width = 2.0});
        const auto value = core::quantity_at(frame_.curve, quantity_, frame_.u);
        if (!value) return;
        mark(frame_.u, *value,
             {.radius = 4.5, .fill = frame_.theme.parameter, .outline = frame_.theme.panel, .outline_width = 1.5});
    }

    PlotFrame& frame_;
    core::Quantity quantity_;
    render::PixelBox box_;
    std::shared_ptr<const Graph> graph_;
    core::Interval values_;
};

void draw_quantity(PlotFrame& frame, core::Quantity quantity) {
    const std::vector<core::Quantity> quantities = plotted_now(frame.state.view);
    for (std::size_t k = 0; k < quantities.size() && k < frame.layout.graphs.size(); ++k)
        if (quantities[k] == quantity) QuantityPlot(frame, quantity, frame.layout.graphs[k]).draw();
}

}  // namespace

void draw_curvature_plot(PlotFrame& frame) {
    draw_quantity(frame, core::Quantity::curvature);
}

void draw_speed_plot(PlotFrame& frame) {
    draw_quantity(frame, core::Quantity::speed);
}

}  // namespace batten::editor
