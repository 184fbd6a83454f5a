#include "app/editor/scene/basis_graphs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "app/editor/scene/text_row.h"
#include "app/editor/scene/text_size.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

constexpr double sample_spacing_px = 3.0;
constexpr double simplification_px = 0.15;
constexpr double index_size = 12.0;
constexpr double number_distance = 10.0;
constexpr double line_clearance = 5.0;

/// The directions from one point in which a line passes near all points since.
class Cone {
  public:
    explicit Cone(glm::dvec2 apex) : apex_(apex) {}

    bool contains(glm::dvec2 point) const {
        const double slope = (point.y - apex_.y) / (point.x - apex_.x);
        return lower_ <= slope && slope <= upper_;
    }
    void narrow_to(glm::dvec2 point) {
        const double run = point.x - apex_.x;
        lower_ = std::max(lower_, (point.y - simplification_px - apex_.y) / run);
        upper_ = std::min(upper_, (point.y + simplification_px - apex_.y) / run);
    }

  private:
    glm::dvec2 apex_;
    double lower_ = -std::numeric_limits<double>::infinity();
    double upper_ = std::numeric_limits<double>::infinity();
};

/// The same graph with fewer points: none of those left out is farther than `simplification_px` above or below. Of
/// points with the same x, where doubles cannot tell the parameters apart, only the first counts.
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points) {
    std::vector<glm::dvec2> kept{points.front()};
    Cone cone(points.front());
    glm::dvec2 last = points.front();
    for (const glm::dvec2 point : points) {
        if (!(point.x > last.x)) continue;
        if (!cone.contains(point)) {
            kept.push_back(last);
            cone = Cone(last);
        }
        cone.narrow_to(point);
        last = point;
    }
    kept.push_back(last);
    return kept;
}

/// The values of the local points that are different ones: of a periodic curve with few points several are the same
/// point, whose values add up.
std::vector<double> values_by_function(const PlotFrame& frame, std::vector<double> values) {
    const std::size_t n = frame.curve.control_points().size();
    for (std::size_t j = n; j < values.size(); ++j) values[j % n] += values[j];
    values.resize(std::min(n, values.size()));
    return values;
}

/// Samples all functions of one span after the other.
class GraphTracer {
  public:
    explicit GraphTracer(const PlotFrame& frame) : frame_(frame), graphs_(frame.curve.control_points().size()) {}

    std::vector<BasisGraph> trace() {
        const core::KnotVector& knots = frame_.curve.knots();
        const auto p = static_cast<std::size_t>(frame_.curve.degree());
        for (std::size_t s = p; s + p + 1 < knots.size(); ++s) {
            const double lower = std::max(knots[s], frame_.layout.range.lower);
            const double upper = std::min(knots[s + 1], frame_.layout.range.upper);
            if (lower < upper) trace_span(s, {lower, upper});
        }
        return std::move(graphs_);
    }

  private:
    void trace_span(std::size_t s, core::Interval shown) {
        const auto p = static_cast<std::size_t>(frame_.curve.degree());
        const double width = frame_.x(shown.upper) - frame_.x(shown.lower);
        const int steps = p == 1 ? 1 : static_cast<int>(std::clamp(width / sample_spacing_px, 4.0, 1000.0));
        std::vector<std::vector<glm::dvec2>> samples(p + 1);
        for (int k = 0; k <= steps; ++k) {
            const double u = k == steps ? shown.upper : shown.lower + shown.length() * k / steps;
            const core::Side side = u < frame_.curve.knots()[s + 1] ? core::Side::right : core::Side::left;
            const std::vector<double> values = core::basis_functions(frame_.curve.knots(), u, 0, side).derivatives[0];
            add_sample(samples, u, values);
        }
        for (std::size_t j = 0; j <= p; ++j)
            if (!samples[j].empty()) append(graphs_[frame_.function_of(s, j)], samples[j]);
    }

    void add_sample(std::vector<std::vector<glm::dvec2>>& samples, double u, const std::vector<double>& values) const {
        const std::vector<double> sums = values_by_function(frame_, values);
        for (std::size_t j = 0; j < sums.size(); ++j) samples[j].push_back({frame_.x(u), frame_.y(sums[j])});
    }

    static void append(BasisGraph& graph, const std::vector<glm::dvec2>& samples) {
        for (const glm::dvec2 place : samples)
            if (place.y < graph.peak.y) graph.peak = place;
        std::vector<glm::dvec2> piece = simplified(samples);
        const bool goes_on = !graph.runs.empty() && glm::distance(graph.runs.back().back(), piece.front()) < 0.01;
        if (!goes_on) {
            graph.runs.push_back(std::move(piece));
        } else {
            auto& run = graph.runs.back();
            run.insert(run.end(), piece.begin() + 1, piece.end());
        }
    }

    const PlotFrame& frame_;
    std::vector<BasisGraph> graphs_;
};

bool is_active(const PlotFrame& frame, std::size_t i) {
    for (std::size_t j = 0; j <= static_cast<std::size_t>(frame.curve.degree()); ++j)
        if (frame.function_of(frame.span, j) == i) return true;
    return false;
}

bool is_lit(const PlotFrame& frame, std::size_t i) {
    return std::binary_search(frame.lit.basis.begin(), frame.lit.basis.end(), i);
}

Stroke stroke_of(const PlotFrame& frame, std::size_t i) {
    const render::Color color = frame.theme.point(i);
    if (is_lit(frame, i)) return {.color = color, .width = 3.5};
    if (is_active(frame, i)) return {.color = color, .width = 2.25};
    return {.color = frame.theme.resting_point(i), .width = 1.25};
}

/// The order in which graphs are drawn: what matters more comes later.
int rank_of(const PlotFrame& frame, std::size_t i) {
    return is_lit(frame, i) ? 2 : is_active(frame, i) ? 1 : 0;
}

std::vector<std::size_t> by_rank(const PlotFrame& frame, std::size_t count) {
    std::vector<std::size_t> order;
    for (const int rank : {0, 1, 2})
        for (std::size_t i = 0; i < count; ++i)
            if (rank_of(frame, i) == rank) order.push_back(i);
    return order;
}

/// Above the peak, but away from the edges, where the numbers of the axis stand, and beside the line at u, which would
/// cross the number.
double number_x(const PlotFrame& frame, double peak_x, double width_px) {
    const double inset = frame.pen.px(8.0);
    const double x = std::clamp(peak_x, frame.layout.left_px + inset, frame.layout.right_px - inset);
    const double line_x = frame.x(frame.u);
    const double clear = 0.5 * width_px + frame.pen.px(line_clearance);
    if (std::abs(x - line_x) >= clear) return x;
    const bool is_right = x >= line_x ? line_x + clear <= frame.pen.size_px().x - width_px : line_x - clear < width_px;
    return is_right ? line_x + clear : line_x - clear;
}

}  // namespace

std::vector<BasisGraph> basis_graphs(const PlotFrame& frame) {
    return GraphTracer(frame).trace();
}

void draw_basis_graphs(PlotFrame& frame, const std::vector<BasisGraph>& graphs) {
    for (const std::size_t i : by_rank(frame, graphs.size()))
        for (const auto& run : graphs[i].runs) frame.pen.line(run, stroke_of(frame, i));
}

void draw_basis_numbers(PlotFrame& frame, const std::vector<BasisGraph>& graphs) {
    TextRow row;
    std::vector<std::size_t> order = by_rank(frame, graphs.size());
    std::reverse(order.begin(), order.end());
    for (const std::size_t i : order) {
        if (graphs[i].runs.empty()) continue;
        const std::string number = std::to_string(i);
        const TextStyle style{.color = frame.theme.point_text(i),
                              .size = index_size,
                              .anchor = render::Anchor::center,
                              .font = render::LabelFont::bold};
        const double width = text_size(number, frame.pen.px(index_size), style.font).x;
        row.write(frame.pen,
                  {number_x(frame, graphs[i].peak.x, width), graphs[i].peak.y - frame.pen.px(number_distance)}, number,
                  style);
    }
}

void draw_basis_values(PlotFrame& frame) {
    if (!frame.layout.range.contains(frame.u)) return;
    const std::vector<double> values =
        values_by_function(frame, core::basis_functions(frame.curve.knots(), frame.u).derivatives[0]);
    for (std::size_t j = 0; j < values.size(); ++j)
        frame.pen.symbol({frame.x(frame.u), frame.y(values[j])},
                         {.radius = 4.0,
                          .fill = frame.theme.point(frame.function_of(frame.span, j)),
                          .outline = frame.theme.panel,
                          .outline_width = 1.5});
}

}  // namespace batten::editor
