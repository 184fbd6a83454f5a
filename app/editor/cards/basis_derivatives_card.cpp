#include "app/editor/cards/basis_derivatives_card.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/editor/cards/card_texts.h"
#include "app/editor/derived/shown_function.h"
#include "app/editor/pointer/plot_layout.h"
#include "app/editor/scene/plot_intervals.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/words/basis_formula.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

// Design pixels.
constexpr double derivatives_height = 150.0;
constexpr double left_margin = 44.0;
constexpr double right_margin = 8.0;
constexpr double derivatives_top_margin = 8.0;
constexpr double derivative_spacing = 4.0;

/// The least of 1, 2, 5, 10, 20, ... that is no less than `value`, so that the scale stands still while knots move.
double round_scale(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (value <= factor * power * (1.0 + 1e-9)) return factor * power;
    return 10.0 * power;
}

/// The graphs of one derivative.
class DerivativePicture {
  public:
    DerivativePicture(const EditorState& state, int order, glm::dvec2 size_px, double scale, render::DrawList& list)
        : state_(state),
          theme_(shown_theme(state.view)),
          curve_(*state.active_curve()),
          basis_(state.derived.plot_basis(curve_.knots())),
          range_(state.view.plot_range.value_or(whole_plot_range(state))),
          order_(order),
          pen_(list, size_px, scale, state.view.notation) {
        trace();
    }

    void draw() {
        if (lines_.empty()) {
            pen_.text(0.5 * pen_.size_px(), "Too many functions: zoom the plot in.",
                      {.color = theme_.dim, .anchor = render::Anchor::center});
            return;
        }
        for (const double share : {-1.0, 0.0, 1.0}) draw_level(share);
        for (const bool acts : {false, true})
            for (const auto& [number, runs] : lines_) draw_function(number, runs, acts);
        draw_parameter();
    }

  private:
    using Runs = std::vector<std::vector<glm::dvec2>>;  // a run for each span: parameters and values

    void trace() {
        const double width = pen_.size_px().x - pen_.px(left_margin + right_margin);
        std::size_t span = 0;
        for (const PlotInterval& interval :
             plot_intervals(basis_->knots(), range_, width, pen_.px(derivative_spacing))) {
            if (interval.span != span) add(interval.span, interval.u.lower, core::Side::right, true);
            add(interval.span, interval.u.upper, core::Side::left, false);
            span = interval.span;
        }
        scale_ = round_scale(largest_);
    }

    void add(std::size_t span, double u, core::Side side, bool begins) {
        const core::BasisRow values = core::basis_functions(basis_->knots(), u, order_, side).derivatives.back();
        for (std::size_t j = 0; j < values.size(); ++j) {
            if (!basis_->function(span, j) || !std::isfinite(values[j])) continue;
            Runs& runs = lines_[span - static_cast<std::size_t>(curve_.degree()) + j];
            if (begins || runs.empty()) runs.emplace_back();
            runs.back().push_back({u, values[j]});
            largest_ = std::max(largest_, std::abs(values[j]));
        }
    }

    glm::dvec2 place(glm::dvec2 at) const {
        const double left = pen_.px(left_margin);
        const double width = pen_.size_px().x - left - pen_.px(right_margin);
        const double half = 0.5 * pen_.size_px().y - pen_.px(derivatives_top_margin);
        return {left + (at.x - range_.lower) / range_.length() * width, 0.5 * pen_.size_px().y - at.y / scale_ * half};
    }

    void draw_level(double share) {
        const glm::dvec2 begin = place({range_.lower, share * scale_});
        pen_.segment(begin, place({range_.upper, share * scale_}), {.color = theme_.line});
        pen_.text(begin - glm::dvec2(pen_.px(6.0), 0.0), number_text(share * scale_),
                  {.color = theme_.dim, .size = 11.0, .anchor = render::Anchor::right});
    }

    std::size_t index_of(std::size_t number) const { return (number - basis_->number_of(0)) % basis_->count(); }

    void draw_function(std::size_t number, const Runs& runs, bool acts) {
        const core::KnotVector& knots = basis_->knots();
        const auto p = static_cast<std::size_t>(knots.degree());
        const double u = state_.parameter();
        if ((knots[number] <= u && u <= knots[number + p + 1]) != acts) return;
        const std::size_t index = index_of(number);
        const std::size_t hue = point_hue(*state_.shown().active_curve(), index);
        for (const std::vector<glm::dvec2>& run : runs) {
            std::vector<glm::dvec2> line;
            for (const glm::dvec2 at : run) line.push_back(place(at));
            pen_.line(line, {.color = acts ? theme_.point(hue) : theme_.resting_point(hue),
                             .width = state_.hover == Hover(HoveredBasis{index}) ? 3.5
                                      : acts                                     ? 2.0
                                                                                 : 1.2});
        }
    }

    void draw_parameter() {
        if (!range_.contains(state_.parameter())) return;
        const double x = place({state_.parameter(), 0.0}).x;
        pen_.segment({x, pen_.px(2.0)}, {x, pen_.size_px().y - pen_.px(2.0)},
                     {.color = theme_.parameter, .width = 2.0});
    }

    const EditorState& state_;
    Theme theme_;
    const core::Curve& curve_;
    std::shared_ptr<const PlotBasis> basis_;
    core::Interval range_;
    int order_;
    Pen pen_;
    std::map<std::size_t, Runs> lines_;  // by the function's number
    double largest_ = 0.0;
    double scale_ = 1.0;
};

CardPicture picture_of(const EditorState& state, int order) {
    return {.height = derivatives_height, .draw = [&state, order](glm::dvec2 size_px, double scale) {
                CardDrawing drawing;
                DerivativePicture(state, order, size_px, scale, drawing.list).draw();
                return drawing;
            }};
}

/// The values of the functions that act at u, seen from the right.
CardTable value_table(const EditorState& state) {
    const core::Curve& curve = *state.active_curve();
    const Theme theme = shown_theme(state.view);
    const core::BasisValues basis = core::basis_functions(curve.knots(), state.parameter(), 2);
    const std::size_t first = basis.span - static_cast<std::size_t>(curve.degree());
    const std::string letter = basis_letter(state, curve.knots());
    CardTable table{.rows = {{{.text = "i"},
                              {.text = letter},
                              {.text = fmt::format("{}′", letter)},
                              {.text = fmt::format("{}″", letter)}}},
                    .has_heading = true};
    std::vector<std::vector<std::string>> columns;
    for (const core::BasisRow& values : basis.derivatives)
        columns.push_back(exact_texts(state.view.notation, without_rounding(values)));
    for (std::size_t j = 0; j < basis.derivatives[0].size(); ++j) {
        const std::size_t index = (first + j) % curve.control_points().size();
        std::vector<CardText> row{{.text = std::to_string(index),
                                   .hover = HoveredBasis{index},
                                   .color = theme.point_text(point_hue(*state.shown().active_curve(), index))}};
        for (const std::vector<std::string>& column : columns) row.push_back({.text = column[j]});
        table.rows.push_back(std::move(row));
    }
    table.rows.push_back({{.text = "sum", .tone = CardTone::strong}, {.text = "1"}, {.text = "0"}, {.text = "0"}});
    return table;
}

}  // namespace

Card basis_derivatives_card(const EditorState& state) {
    Card card{.title = "Derivatives of the basis", .blocks = {}};
    const std::optional<ShownFunction> function = shown_function(state);
    if (!function) return card_without_curve(std::move(card));
    const core::Curve& curve = *state.active_curve();
    const core::Place letter("letter", basis_letter(state, curve.knots()));
    const core::Place degree("p", curve.degree());
    card.line(core::sentence("{letter}′_{{i,{p}}}(u)", {letter, degree}), CardTone::strong).add(picture_of(state, 1));
    if (curve.degree() > 1)
        card.line(core::sentence("{letter}″_{{i,{p}}}(u)", {letter, degree}), CardTone::strong)
            .add(picture_of(state, 2));
    const BasisDerivativeFormula formula =
        basis_derivative_formula(curve.knots(), function->number, state.view.notation);
    card.formula(formula.symbols, CardTone::accent).formula(formula.numbers);
    card.line(
        core::sentence("At u = {u}", {{"u", knot_value_text(curve.knots(), state.parameter(), state.view.notation)}}),
        CardTone::parameter);
    return card.add(value_table(state));
}

}  // namespace batten::editor
