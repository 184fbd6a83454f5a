#include "app/editor/derived/measured.h"

#include <algorithm>
#include <cmath>

#include "app/editor/derived/derived.h"
#include "core/measure/arc_length.h"

namespace batten::editor {

namespace {

core::LineContacts crossings_of(const core::Curve& curve, const ProbeLine& line) {
    return core::intersect_line(curve, line.first, line.second, most_crossed_spans).value();
}

Bends bends_of(const core::Curve& curve, const std::vector<core::Interval>& ranges) {
    Bends bends;
    for (const core::Interval range : ranges) {
        const auto inflections = core::inflections_within(curve, range);
        const auto extrema = core::curvature_extrema_within(curve, range);
        bends.inflections.insert(bends.inflections.end(), inflections.begin(), inflections.end());
        bends.extrema.insert(bends.extrema.end(), extrema.begin(), extrema.end());
    }
    return bends;
}

// Beyond so many times what nine tenths of the values stay below it goes to a pole.
constexpr double pole = 4.0;

Graph graph_of(const core::Curve& curve, const GraphRequest& request) {
    Graph graph{core::quantity_graph(curve, request.quantity, request.range, request.most), {0.0, 0.0}};
    std::vector<double> sizes;
    for (const core::GraphRun& run : graph.runs)
        for (const core::GraphPoint& point : run) sizes.push_back(std::abs(point.value));
    if (sizes.empty()) return graph;
    const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::nth_element(sizes.begin(), rank, sizes.end());
    const double most = *rank > 0.0 ? pole * *rank : *std::ranges::max_element(sizes);
    for (const core::GraphRun& run : graph.runs)
        for (const core::GraphPoint& point : run) {
            graph.values.lower = std::min(graph.values.lower, std::max(point.value, -most));
            graph.values.upper = std::max(graph.values.upper, std::min(point.value, most));
        }
    // Numbers too large to be told apart in a picture are none.
    if (!std::isfinite(1e3 * graph.values.length())) return {};
    return graph;
}

/// With u as a function of the share of the whole, which is 0 and 1 at the ends.
template <class ParameterAt>
EqualParts equal_parts_of(const core::Curve& curve, int count, ParameterAt parameter_at) {
    EqualParts parts;
    for (int k = 0; k <= count; ++k) {
        const double u = k == count ? curve.domain().upper : parameter_at(static_cast<double>(k) / count);
        parts.ends.push_back({u, core::point_at(curve, u, k == count ? core::Side::left : core::Side::right)});
    }
    return parts;
}

EqualParts steps_of(const core::Curve& curve, int count) {
    const core::Interval domain = curve.domain();
    return equal_parts_of(curve, count, [domain](double share) { return domain.lower + share * domain.length(); });
}

EqualParts lengths_of(const core::Curve& curve, int count) {
    if (curve.control_points().size() > most_measured_spans) return {};
    const core::ArcLengthTable table(curve);
    if (!core::is_sharp(table.total()) || !(table.total().value > 0.0)) return {};
    const double total = table.total().value;
    EqualParts parts = equal_parts_of(curve, count, [&](double share) { return table.parameter_at(share * total); });
    parts.length = total / count;
    return parts;
}

}  // namespace

template <class Asked>
bool Measured::are_same(const Question<Asked>& a, const Question<Asked>& b) {
    return a.asked == b.asked && share_arrays(a.curve, b.curve);
}

std::shared_ptr<const core::LineContacts> Measured::crossings(const core::Curve& curve, const ProbeLine& line) const {
    if (!is_line(line)) return nullptr;
    return crossings_.of({curve, line},
                         [](const auto& question) { return crossings_of(question.curve, question.asked); });
}

std::shared_ptr<const Bends> Measured::bends(const core::Curve& curve,
                                             const std::vector<core::Interval>& ranges) const {
    return bends_.of({curve, ranges}, [](const auto& question) { return bends_of(question.curve, question.asked); });
}

std::shared_ptr<const EqualParts> Measured::equal_steps(const core::Curve& curve, int count) const {
    return steps_.of({curve, count}, [](const auto& question) { return steps_of(question.curve, question.asked); });
}

std::shared_ptr<const EqualParts> Measured::equal_lengths(const core::Curve& curve, int count) const {
    return lengths_.of({curve, count}, [](const auto& question) { return lengths_of(question.curve, question.asked); });
}

std::shared_ptr<const Graph> Measured::graph(const core::Curve& curve, const GraphRequest& request) const {
    const auto& graphs = request.quantity == core::Quantity::curvature ? curvatures_ : speeds_;
    return graphs.of({curve, request}, [](const auto& question) { return graph_of(question.curve, question.asked); });
}

}  // namespace batten::editor
