#include "app/editor/scene/rational_graphs.h"

#include <algorithm>
#include <map>

#include "app/editor/scene/plot_intervals.h"
#include "core/evaluate/rational_basis.h"

namespace batten::editor {

namespace {

constexpr double rational_spacing = 4.0;
constexpr double disc_radius = 3.5;

using Places = std::vector<glm::dvec2>;

/// The lines by the functions' numbers on the knots of the plot, so that those of a periodic curve break at its ends.
std::map<std::size_t, Places> rational_lines(const PlotFrame& frame) {
    const core::Interval range{std::max(frame.layout.range.lower, frame.curve.domain().lower),
                               std::min(frame.layout.range.upper, frame.curve.domain().upper)};
    std::map<std::size_t, Places> lines;
    if (!(range.lower < range.upper)) return lines;
    const auto add = [&](double u, core::Side side) {
        const core::RationalBasis basis = core::rational_basis(frame.curve, u, 0, side);
        for (std::size_t j = 0; j < basis.derivatives[0].size(); ++j)
            lines[basis.first + j].push_back({frame.x(u), frame.y(basis.derivatives[0][j])});
    };
    std::size_t span = 0;
    for (const PlotInterval& interval :
         plot_intervals(frame.curve.knots(), range, frame.x(range.upper) - frame.x(range.lower),
                        frame.pen.px(rational_spacing) / frame.state.view.parts.fineness)) {
        if (interval.span != span) add(interval.u.lower, core::Side::right);
        add(interval.u.upper, core::Side::left);
        span = interval.span;
    }
    return lines;
}

}  // namespace

void draw_rational_graphs(PlotFrame& frame) {
    if (!frame.curve.is_rational()) return;
    const std::size_t n = frame.curve.control_points().size();
    for (const auto& [number, line] : rational_lines(frame)) {
        const bool is_lit = std::ranges::binary_search(frame.lit.basis, number % n);
        frame.pen.line(
            line,
            {.color = frame.theme.point(frame.hue(number % n)), .width = is_lit ? 3.5 : 2.25, .dash = 6.0, .gap = 4.0});
    }
    if (!frame.state.view.parts.parameter || !frame.layout.range.contains(frame.u)) return;
    const core::RationalBasis basis = core::rational_basis(frame.curve, frame.u);
    for (std::size_t j = 0; j < basis.derivatives[0].size(); ++j)
        frame.pen.symbol({frame.x(frame.u), frame.y(basis.derivatives[0][j])},
                         {.shape = render::MarkerShape::square,
                          .radius = disc_radius,
                          .fill = frame.theme.point(frame.hue((basis.first + j) % n)),
                          .outline = frame.theme.panel,
                          .outline_width = 1.5});
}

}  // namespace batten::editor
