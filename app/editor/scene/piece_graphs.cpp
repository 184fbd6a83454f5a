#include "app/editor/scene/piece_graphs.h"

#include <algorithm>

#include "app/editor/derived/shown_function.h"
#include "core/evaluate/basis_pieces.h"

namespace batten::editor {

namespace {

constexpr double beyond = 0.6;  // how far a polynomial goes on, in lengths of its span
constexpr int steps_in_span = 60;
constexpr core::Interval shown_values{-0.12, 1.12};

double value_of(const std::vector<double>& coefficients, double t) {
    double value = 0.0;
    for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
    return value;
}

/// The polynomial of a piece between two values of its own parameter, as far as the plot reaches from the first.
void draw_part(PlotFrame& frame, const core::BasisPiece& piece, core::Interval t, double shift, const Stroke& stroke,
               bool begins_at_upper) {
    const int steps = std::max(2, static_cast<int>(steps_in_span * frame.state.view.parts.fineness * t.length()));
    std::vector<glm::dvec2> line;
    for (int n = 0; n <= steps; ++n) {
        const double share = static_cast<double>(n) / steps;
        const double at = begins_at_upper ? t.upper - share * t.length() : t.lower + share * t.length();
        const double u = piece.interval.lower + at * piece.interval.length() + shift;
        const double value = value_of(piece.in_t.coefficients, at);
        if (!frame.layout.range.contains(u) || !shown_values.contains(value)) {
            if (line.empty()) continue;
            break;
        }
        line.emplace_back(frame.x(u), frame.y(value));
    }
    if (line.size() > 1) frame.pen.line(line, stroke);
}

}  // namespace

void draw_piece_graphs(PlotFrame& frame) {
    const HoveredBasisCell cell = shown_basis_cell(frame.state).value();
    const auto pieces = core::basis_pieces(frame.curve.knots(), cell.function, static_cast<int>(cell.degree));
    std::vector<double> shifts{0.0};
    const double period = frame.curve.domain().length();
    if (frame.curve.is_periodic()) shifts = {-period, 0.0, period};
    for (const double shift : shifts)
        for (std::size_t n = 0; n < pieces.size(); ++n) {
            const render::Color color = frame.theme.level(n + 1);
            const Stroke faint{.color = color, .width = 1.5, .dash = 4.0, .gap = 4.0};
            draw_part(frame, pieces[n], {-beyond, 0.0}, shift, faint, true);
            draw_part(frame, pieces[n], {1.0, 1.0 + beyond}, shift, faint, false);
            draw_part(frame, pieces[n], {0.0, 1.0}, shift, {.color = color, .width = 4.0}, false);
        }
}

}  // namespace batten::editor
