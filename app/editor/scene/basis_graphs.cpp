#include "app/editor/scene/basis_graphs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <string>

#include "app/editor/scene/text_row.h"
#include "app/editor/scene/text_size.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

constexpr double sample_spacing_px = 3.0;
constexpr double least_steps = 4.0;         // in a span
constexpr double least_steps_of_one = 2.0;  // where functions are too many
constexpr double most_graph_steps = 1000.0;
constexpr double most_functions_per_px = 0.25;  // functions for each pixel of the plot's width
constexpr double function_cell = 10.0;          // for each of which a narrow function is shown, if they are too many
constexpr double simplification_px = 0.15;
constexpr double index_size = 12.0;
constexpr double number_distance = 10.0;
constexpr double line_clearance = 5.0;

/// The directions from one point in which a line passes near all points since.
class Cone {
  public:
    Cone(glm::dvec2 apex, double reach) : apex_(apex), reach_(reach) {}

    bool contains(glm::dvec2 point) const {
        const double slope = (point.y - apex_.y) / (point.x - apex_.x);
        return lower_ <= slope && slope <= upper_;
    }
    void narrow_to(glm::dvec2 point) {
        const double run = point.x - apex_.x;
        lower_ = std::max(lower_, (point.y - reach_ - apex_.y) / run);
        upper_ = std::min(upper_, (point.y + reach_ - apex_.y) / run);
    }

  private:
    glm::dvec2 apex_;
    double reach_;
    double lower_ = -std::numeric_limits<double>::infinity();
    double upper_ = std::numeric_limits<double>::infinity();
};

/// The same graph with fewer points: none of those left out is farther than `reach` above or below. Of
/// points with the same x, where doubles cannot tell the parameters apart, only the first counts.
std::vector<glm::dvec2> simplified(const std::vector<glm::dvec2>& points, double reach) {
    std::vector<glm::dvec2> kept{points.front()};
    Cone cone(points.front(), reach);
    glm::dvec2 last = points.front();
    for (const glm::dvec2 point : points) {
        if (!(point.x > last.x)) continue;
        if (!cone.contains(point)) {
            kept.push_back(last);
            cone = Cone(last, reach);
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

/// The spans that the plot shows, of the vector over which the functions have their whole supports.
struct SpanRange {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// The functions that do not vanish over all the spans, as numbers in that vector.
struct FunctionRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

FunctionRange functions_of(const PlotFrame& frame, SpanRange spans) {
    const std::size_t lowest = spans.first - static_cast<std::size_t>(frame.curve.degree());
    const std::size_t n = frame.basis->count();
    if (frame.curve.is_periodic()) return {lowest, std::min(spans.last - lowest + 1, n)};
    const std::size_t first = std::max(lowest, frame.basis->number_of(0));
    return {first, std::min(spans.last, frame.basis->number_of(n - 1)) - first + 1};
}

SpanRange shown_spans(const PlotFrame& frame) {
    const core::KnotVector& knots = frame.basis->knots();
    return {knots.span_at(std::max(frame.layout.range.lower, knots.domain().lower)),
            knots.span_at(std::min(frame.layout.range.upper, knots.domain().upper), core::Side::left)};
}

/// Samples functions span by span.
class GraphTracer {
  public:
    explicit GraphTracer(const PlotFrame& frame) : frame_(frame) {}

    /// All functions of the spans.
    std::vector<BasisGraph> trace(SpanRange spans) {
        const FunctionRange functions = functions_of(frame_, spans);
        std::vector<BasisGraph> graphs(functions.count);
        for (std::size_t k = 0; k < graphs.size(); ++k)
            graphs[k].index = (functions.first - frame_.basis->number_of(0) + k) % frame_.basis->count();
        for (std::size_t s = spans.first; s <= spans.last; ++s) {
            const auto samples = samples_of(s, least_steps);
            for (std::size_t j = 0; j < samples.size(); ++j)
                if (frame_.basis->function(s, j))
                    append(graphs[(s - degree() + j - functions.first) % graphs.size()], samples[j]);
        }
        std::sort(graphs.begin(), graphs.end(),
                  [](const BasisGraph& a, const BasisGraph& b) { return a.index < b.index; });
        return graphs;
    }

    /// One function, as far as it is in the spans. There must be more functions than a span has.
    BasisGraph trace(SpanRange spans, std::size_t index) {
        BasisGraph graph{.index = index, .runs = {}};
        for (std::size_t i = frame_.basis->number_of(index); i <= spans.last; i += frame_.basis->count()) {
            for (std::size_t s = std::max(i, spans.first); s <= std::min(i + degree(), spans.last); ++s) {
                const auto samples = samples_of(s, least_steps_of_one);
                if (!samples.empty()) append(graph, samples[i + degree() - s]);
            }
            if (!frame_.curve.is_periodic()) break;
        }
        return graph;
    }

  private:
    std::size_t degree() const { return static_cast<std::size_t>(frame_.curve.degree()); }
    double fineness() const { return frame_.state.view.parts.fineness; }

    /// The functions of one span in the shown range, sampled at its ends and between.
    std::vector<std::vector<glm::dvec2>> samples_of(std::size_t s, double least) const {
        const core::KnotVector& knots = frame_.basis->knots();
        const core::Interval shown{std::max(knots[s], frame_.layout.range.lower),
                                   std::min(knots[s + 1], frame_.layout.range.upper)};
        if (!(shown.lower < shown.upper)) return {};
        const double width = frame_.x(shown.upper) - frame_.x(shown.lower);
        const int steps =
            degree() == 1
                ? 1
                : static_cast<int>(std::clamp(fineness() * width / sample_spacing_px, least, most_graph_steps));
        std::vector<std::vector<glm::dvec2>> samples(std::min(degree() + 1, frame_.curve.control_points().size()));
        for (int k = 0; k <= steps; ++k) {
            const double u = k == steps ? shown.upper : shown.lower + shown.length() * (static_cast<double>(k) / steps);
            const core::Side side = u < knots[s + 1] ? core::Side::right : core::Side::left;
            add_sample(samples, u, core::basis_functions(knots, u, 0, side).derivatives[0]);
        }
        return samples;
    }

    void add_sample(std::vector<std::vector<glm::dvec2>>& samples, double u, const std::vector<double>& values) const {
        const std::vector<double> sums = values_by_function(frame_, values);
        for (std::size_t j = 0; j < sums.size(); ++j) samples[j].push_back({frame_.x(u), frame_.y(sums[j])});
    }

    void append(BasisGraph& graph, const std::vector<glm::dvec2>& samples) const {
        for (const glm::dvec2 place : samples)
            if (place.y < graph.peak.y) graph.peak = place;
        std::vector<glm::dvec2> piece = simplified(samples, simplification_px / std::pow(fineness(), 2));
        const bool goes_on = !graph.runs.empty() && glm::distance(graph.runs.back().back(), piece.front()) < 0.01;
        if (!goes_on) {
            graph.runs.push_back(std::move(piece));
        } else {
            auto& run = graph.runs.back();
            run.insert(run.end(), piece.begin() + 1, piece.end());
        }
    }

    const PlotFrame& frame_;
};

void make_ascending(std::vector<std::size_t>& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

/// The functions to show where they are too many, whatever the parameter: ascending.
std::vector<std::size_t> resting_functions(const PlotFrame& frame, SpanRange spans) {
    const core::KnotVector& knots = frame.curve.knots();
    const auto p = static_cast<std::size_t>(frame.curve.degree());
    const std::size_t n = frame.curve.control_points().size();
    std::vector<std::size_t> chosen;
    const double cell =
        frame.pen.px(function_cell) * frame.layout.range.length() / (frame.layout.right_px - frame.layout.left_px);
    // Cells lie still while the plot moves.
    const double start = std::floor(frame.layout.range.lower / cell) * cell;
    for (double k = 0.0; start + k * cell <= frame.layout.range.upper; k += 1.0)
        if (frame.layout.range.contains(start + k * cell) && knots.domain().contains(start + k * cell))
            chosen.push_back(frame.function_of(knots.span_at(start + k * cell), p / 2));
    const FunctionRange functions = functions_of(frame, spans);
    const core::KnotVector& whole = frame.basis->knots();
    for (std::size_t i = functions.first; i < functions.first + functions.count; ++i)
        if (whole[i + p + 1] - whole[i] >= static_cast<double>(p + 1) * cell)
            chosen.push_back((i - frame.basis->number_of(0)) % n);
    make_ascending(chosen);
    return chosen;
}

/// These, and those that act at the parameter or are lit.
std::vector<std::size_t> chosen_functions(const PlotFrame& frame, SpanRange spans, BasisCache& cache) {
    std::vector<std::size_t> chosen = cache.chosen([&] { return resting_functions(frame, spans); });
    chosen.insert(chosen.end(), frame.lit.basis.begin(), frame.lit.basis.end());
    for (std::size_t j = 0; j <= static_cast<std::size_t>(frame.curve.degree()); ++j)
        chosen.push_back(frame.function_of(frame.span, j));
    make_ascending(chosen);
    return chosen;
}

bool is_active(const PlotFrame& frame, std::size_t i) {
    if (!frame.state.view.parts.parameter) return true;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(frame.curve.degree()); ++j)
        if (frame.function_of(frame.span, j) == i) return true;
    return false;
}

bool is_lit(const PlotFrame& frame, std::size_t i) {
    return std::binary_search(frame.lit.basis.begin(), frame.lit.basis.end(), i);
}

Stroke stroke_of(const PlotFrame& frame, std::size_t i) {
    const render::Color color = frame.theme.point(frame.hue(i));
    if (is_lit(frame, i)) return {.color = color, .width = 3.5};
    if (is_active(frame, i)) return {.color = color, .width = 2.25};
    return {.color = frame.theme.resting_point(frame.hue(i)), .width = 1.25};
}

/// The order in which graphs are drawn: what matters more comes later.
int rank_of(const PlotFrame& frame, std::size_t i) {
    return is_lit(frame, i) ? 2 : is_active(frame, i) ? 1 : 0;
}

/// The places of the graphs in the order in which they are drawn.
std::vector<std::size_t> by_rank(const PlotFrame& frame, const std::vector<const BasisGraph*>& graphs) {
    std::vector<std::size_t> order(graphs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rank_of(frame, graphs[a]->index) < rank_of(frame, graphs[b]->index);
    });
    return order;
}

/// Above the peak, but away from the edges, where the numbers of the axis stand, and beside the line at u, which would
/// cross the number.
double number_x(const PlotFrame& frame, double peak_x, double width_px) {
    const double inset = frame.pen.px(8.0);
    const double x = std::clamp(peak_x, frame.layout.left_px + inset, frame.layout.right_px - inset);
    const double line_x = frame.x(frame.u);
    const double clear = 0.5 * width_px + frame.pen.px(line_clearance);
    if (!frame.state.view.parts.parameter || std::abs(x - line_x) >= clear) return x;
    const bool is_right = x >= line_x ? line_x + clear <= frame.pen.size_px().x - width_px : line_x - clear < width_px;
    return is_right ? line_x + clear : line_x - clear;
}

}  // namespace

ShownBasis basis_graphs(const PlotFrame& frame, BasisCache& cache) {
    cache.follow(frame.curve.knots(), frame.layout);
    const core::Interval domain = frame.basis->knots().domain();
    ShownBasis shown;
    if (!(domain.lower < frame.layout.range.upper && frame.layout.range.lower < domain.upper)) return shown;
    const SpanRange spans = shown_spans(frame);
    const auto p = static_cast<std::size_t>(frame.curve.degree());
    shown.count = functions_of(frame, spans).count;
    GraphTracer tracer(frame);
    if (static_cast<double>(shown.count) <= most_functions_per_px * frame.pen.size_px().x ||
        shown.count <= 2 * (p + 1)) {
        for (const BasisGraph& graph : cache.all([&] { return tracer.trace(spans); })) shown.graphs.push_back(&graph);
        return shown;
    }
    for (const std::size_t i : chosen_functions(frame, spans, cache)) {
        const BasisGraph& graph = cache.single(i, [&](std::size_t index) { return tracer.trace(spans, index); });
        if (!graph.runs.empty()) shown.graphs.push_back(&graph);
    }
    return shown;
}

void draw_basis_graphs(PlotFrame& frame, const std::vector<const BasisGraph*>& graphs) {
    for (const std::size_t k : by_rank(frame, graphs))
        for (const auto& run : graphs[k]->runs) frame.pen.line(run, stroke_of(frame, graphs[k]->index));
}

void draw_basis_numbers(PlotFrame& frame, const std::vector<const BasisGraph*>& graphs) {
    TextRow row;
    std::vector<std::size_t> order = by_rank(frame, graphs);
    std::reverse(order.begin(), order.end());
    for (const std::size_t k : order) {
        const BasisGraph& graph = *graphs[k];
        if (graph.runs.empty()) continue;
        const std::string number = std::to_string(graph.index);
        const TextStyle style{.color = frame.theme.point_text(frame.hue(graph.index)),
                              .size = index_size,
                              .anchor = render::Anchor::center,
                              .font = render::LabelFont::bold};
        const double width = text_size(number, frame.pen.px(index_size), style.font).x;
        row.write(frame.pen, {number_x(frame, graph.peak.x, width), graph.peak.y - frame.pen.px(number_distance)},
                  number, style);
    }
}

void draw_basis_values(PlotFrame& frame) {
    if (!frame.state.view.parts.parameter || !frame.layout.range.contains(frame.u)) return;
    const std::vector<double> values =
        values_by_function(frame, core::basis_functions(frame.curve.knots(), frame.u).derivatives[0]);
    for (std::size_t j = 0; j < values.size(); ++j)
        frame.pen.symbol({frame.x(frame.u), frame.y(values[j])},
                         {.radius = 4.0,
                          .fill = frame.theme.point(frame.hue(frame.function_of(frame.span, j))),
                          .outline = frame.theme.panel,
                          .outline_width = 1.5});
}

}  // namespace batten::editor
