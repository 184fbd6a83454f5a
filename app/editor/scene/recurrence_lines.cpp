#include "app/editor/scene/recurrence_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/scene/plot_axes.h"
#include "app/editor/scene/text_row.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/basis_formula.h"
#include "core/evaluate/basis_triangle.h"

namespace batten::editor {

namespace {

constexpr double cell_sample_spacing_px = 3.0;
constexpr double most_cell_steps = 400.0;  // in a span
constexpr double veil = 0.72;
constexpr double recurrence_label_distance = 10.0;
constexpr double function_name_size = 13.0;
constexpr double formula_size = 13.0;
constexpr double title_room = 190.0;    // on the left
constexpr double readout_room = 150.0;  // on the right

/// Draws functions of any degree of the recurrence, in a periodic plot each repetition that is seen.
class CellDrawing {
  public:
    explicit CellDrawing(PlotFrame& frame) : frame_(frame), knots_(frame.curve.knots()) {
        const double period = frame.curve.domain().length();
        if (frame.curve.is_periodic()) shifts_ = {-period, 0.0, period};
    }

    void draw(HoveredBasisCell cell) {
        cover();
        draw_parameter_line(frame_);
        const std::size_t i = cell.function;
        const std::size_t k = cell.degree;
        if (k > 0) {
            draw_function(i, k - 1, thin(i));
            draw_function(i + 1, k - 1, thin(i + 1));
            draw_ramp(i, i + k, color(i));
            draw_ramp(i + k + 1, i + 1, color(i + 1));
        }
        draw_function(i, k, {.color = color(i), .width = 3.5});
        if (k > 0) {
            name_function(i, k - 1);
            name_function(i + 1, k - 1);
        }
        name_function(i, k);
        if (k > 0) write_formula(i, k);
    }

  private:
    using Line = std::vector<glm::dvec2>;

    render::Color color(std::size_t i) const {
        return frame_.theme.point(frame_.hue(i % frame_.curve.control_points().size()));
    }
    Stroke thin(std::size_t i) const { return {.color = color(i), .width = 2.0, .dash = 7.0, .gap = 4.0}; }

    void cover() {
        frame_.pen.fill(corners_of({{frame_.layout.left_px, 0.5 * frame_.layout.top_px},
                                    {frame_.layout.right_px, frame_.layout.bottom_px + frame_.pen.px(2.0)}}),
                        render::faded(frame_.theme.panel, veil));
    }

    bool is_seen(double lower, double upper) const {
        return lower < frame_.layout.range.upper && frame_.layout.range.lower < upper;
    }

    double value(std::size_t i, std::size_t k, double u, core::Side side) const {
        return core::lower_basis_function(knots_, i, static_cast<int>(k), u, side);
    }

    /// The graph over one span, as far as it is shown.
    Line line_over(std::size_t i, std::size_t k, std::size_t s, double shift) const {
        const double lower = std::max(knots_[s], frame_.layout.range.lower - shift);
        const double upper = std::min(knots_[s + 1], frame_.layout.range.upper - shift);
        if (!(lower < upper)) return {};
        const double width = frame_.x(upper) - frame_.x(lower);
        const int steps =
            k <= 1 ? 1 : static_cast<int>(std::clamp(width / cell_sample_spacing_px, 4.0, most_cell_steps));
        Line line;
        for (int n = 0; n <= steps; ++n) {
            const double u = n == steps ? upper : lower + (upper - lower) * n / steps;
            const core::Side side = u < knots_[s + 1] ? core::Side::right : core::Side::left;
            line.push_back({frame_.x(u + shift), frame_.y(value(i, k, u, side))});
        }
        return line;
    }

    void draw_function(std::size_t i, std::size_t k, const Stroke& stroke) {
        for (const double shift : shifts_) {
            Line whole;
            for (std::size_t s = i; s <= i + k; ++s) {
                const Line line = line_over(i, k, s, shift);
                whole.insert(whole.end(), line.begin(), line.end());
            }
            if (!whole.empty()) frame_.pen.line(whole, stroke);
        }
    }

    void draw_ramp(std::size_t zero, std::size_t one, render::Color color) {
        if (knots_[zero] == knots_[one]) return;
        for (const double shift : shifts_) {
            const double from = knots_[zero] + shift;
            const double to = knots_[one] + shift;
            if (!is_seen(std::min(from, to), std::max(from, to))) continue;
            frame_.pen.segment(inside(from, to, 0.0, 1.0), inside(to, from, 1.0, 0.0), {.color = color, .width = 1.5});
        }
    }

    /// The place of `u` on a line, or where it leaves the plot.
    glm::dvec2 inside(double u, double other, double value, double other_value) const {
        const double cut = frame_.layout.range.clamp(u);
        return {frame_.x(cut), frame_.y(value + (cut - u) / (other - u) * (other_value - value))};
    }

    /// In the row of the title, where there is room.
    void write_formula(std::size_t i, std::size_t k) {
        const core::BasisTriangle triangle = core::basis_triangle(knots_, std::min(i, last_whole()), frame_.u);
        const std::size_t j = i - triangle.levels[0].front().index;
        if (j >= triangle.levels[k].size()) return;
        const RecurrenceFormula formula = recurrence_formula(knots_, triangle, k, j, frame_.state.view.notation);
        const std::string text = fmt::format("{} {}", formula.symbols[0], formula.symbols[1]);
        const double width = text_size(text, frame_.pen.px(formula_size)).x;
        const core::Interval room{frame_.pen.px(title_room), frame_.pen.size_px().x - frame_.pen.px(readout_room)};
        if (width > room.upper - room.lower) return;
        frame_.pen.text({room.lower + 0.5 * (room.upper - room.lower), 0.4 * frame_.layout.top_px}, text,
                        {.color = frame_.theme.text, .size = formula_size, .anchor = render::Anchor::center});
    }

    /// The last function of full degree.
    std::size_t last_whole() const { return knots_.size() - static_cast<std::size_t>(knots_.degree()) - 2; }

    void name_function(std::size_t i, std::size_t k) {
        if (knots_[i] == knots_[i + k + 1]) return;
        for (const double shift : shifts_) {
            const glm::dvec2 top = peak(i, k, shift);
            if (top.x >= 0.0) write_name(top - glm::dvec2(0.0, frame_.pen.px(recurrence_label_distance)), i, k);
        }
    }

    /// On a ground of its own: lines cross there.
    void write_name(glm::dvec2 place, std::size_t i, std::size_t k) {
        const std::string name = basis_name(i, k);
        const glm::dvec2 half = 0.5 * text_size(name, frame_.pen.px(function_name_size), render::LabelFont::bold) -
                                glm::dvec2(0.0, frame_.pen.px(2.0));
        frame_.pen.fill(corners_of({place - half, place + half}), render::faded(frame_.theme.panel, veil));
        row_.write(frame_.pen, place, name,
                   {.color = frame_.theme.point_text(frame_.hue(i % frame_.curve.control_points().size())),
                    .size = function_name_size,
                    .anchor = render::Anchor::center,
                    .font = render::LabelFont::bold});
    }

    /// The highest place of what is shown; left of the picture where nothing is.
    glm::dvec2 peak(std::size_t i, std::size_t k, double shift) const {
        glm::dvec2 highest{-1.0, 1e30};
        for (std::size_t s = i; s <= i + k; ++s)
            for (const glm::dvec2 place : line_over(i, k, s, shift))
                if (place.y < highest.y) highest = place;
        if (k == 0 && highest.x >= 0.0)
            highest.x = frame_.x(frame_.layout.range.clamp(knots_[i] + shift + 0.5 * (knots_[i + 1] - knots_[i])));
        return highest;
    }

    PlotFrame& frame_;
    const core::KnotVector& knots_;
    std::vector<double> shifts_{0.0};
    TextRow row_;
};

}  // namespace

bool shows_recurrence(const PlotFrame& frame) {
    return frame.state.view.overlays.is_shown(Overlay::recurrence) &&
           std::holds_alternative<HoveredBasisCell>(frame.state.hover);
}

void draw_recurrence_lines(PlotFrame& frame) {
    if (const auto* cell = std::get_if<HoveredBasisCell>(&frame.state.hover)) CellDrawing(frame).draw(*cell);
}

}  // namespace batten::editor
