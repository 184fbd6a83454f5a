#include "app/editor/scene/basis_areas.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/editor/derived/shown_function.h"
#include "app/editor/scene/plot_axes.h"
#include "app/editor/scene/plot_intervals.h"
#include "app/editor/scene/recurrence_lines.h"
#include "app/editor/scene/text_row.h"
#include "app/editor/scene/text_size.h"
#include "core/base/sentence.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

constexpr double area_spacing = 6.0;
constexpr double overlap = 1.0;             // of areas side by side, so that nothing shines through
constexpr double least_area_height = 15.0;  // of an area with a text
constexpr double least_plot_width = 120.0;  // of a plot with names
constexpr double active_ink = 0.55;
constexpr double resting_ink = 0.28;

/// One area between two samples: how high it begins and ends, on the left and on the right.
struct Slice {
    std::size_t index;   ///< of the control point
    std::size_t number;  ///< of the function by the knots of the plot
    core::Interval left;
    core::Interval right;
};

/// The slices between the values at two neighboring samples, from the bottom up; functions without a control point are
/// left out.
std::vector<Slice> slices_over(const PlotFrame& frame, std::size_t span, const core::BasisRow& left,
                               const core::BasisRow& right) {
    std::vector<Slice> slices;
    double left_sum = 0.0;
    double right_sum = 0.0;
    for (std::size_t j = 0; j < left.size(); ++j) {
        const auto index = frame.basis->function(span, j);
        if (!index) continue;
        slices.push_back({*index,
                          span + j - static_cast<std::size_t>(frame.curve.degree()),
                          {left_sum, left_sum + left[j]},
                          {right_sum, right_sum + right[j]}});
        left_sum += left[j];
        right_sum += right[j];
    }
    return slices;
}

class AreaDrawing {
  public:
    explicit AreaDrawing(PlotFrame& frame) : frame_(frame) {
        for (std::size_t j = 0; j <= static_cast<std::size_t>(frame.curve.degree()); ++j)
            active_.push_back(frame.function_of(frame.span, j));
    }

    void draw(const std::vector<PlotInterval>& intervals) {
        core::BasisRow left;
        std::size_t span = 0;
        for (const PlotInterval& interval : intervals) {
            if (interval.span != span) left = values_at(interval.u.lower, core::Side::right);
            core::BasisRow right = values_at(interval.u.upper, core::Side::left);
            for (const Slice& slice : slices_over(frame_, interval.span, left, right)) draw_slice(interval, slice);
            left = std::move(right);
            span = interval.span;
        }
        draw_parameter_line(frame_);
        if (frame_.layout.range.contains(frame_.u)) draw_values();
        for (const auto& [number, place] : widest_) draw_name(place);
    }

  private:
    struct NamePlace {
        std::size_t index;
        double height = 0.0;
        glm::dvec2 middle{};
    };

    core::BasisRow values_at(double u, core::Side side) const {
        return core::basis_functions(frame_.basis->knots(), u, 0, side).derivatives[0];
    }

    std::string name(std::size_t index) const { return function_name(frame_.state, frame_.curve.knots(), index); }

    render::Color color(std::size_t index) const {
        const bool is_lit = std::ranges::binary_search(frame_.lit.basis, index);
        const double ink = is_lit                                               ? 0.85
                           : std::ranges::find(active_, index) != active_.end() ? active_ink
                                                                                : resting_ink;
        return render::blended(frame_.theme.point(frame_.hue(index)), ink, frame_.theme.panel);
    }

    void draw_slice(const PlotInterval& interval, const Slice& slice) {
        const double left = frame_.x(interval.u.lower);
        const double right = frame_.x(interval.u.upper);
        const double end = std::min(right + frame_.pen.px(overlap), frame_.layout.right_px);
        frame_.pen.fill({{left, frame_.y(slice.left.lower)},
                         {left, frame_.y(slice.left.upper)},
                         {end, frame_.y(slice.right.upper)},
                         {end, frame_.y(slice.right.lower)}},
                        color(slice.index));
        const double height = frame_.y(slice.left.lower) - frame_.y(slice.left.upper);
        NamePlace& widest = widest_.try_emplace(slice.number, NamePlace{slice.index}).first->second;
        if (height <= widest.height) return;
        widest.height = height;
        widest.middle = {left, 0.5 * (frame_.y(slice.left.lower) + frame_.y(slice.left.upper))};
    }

    /// On the line at u each value as high as it is, and the sum above.
    void draw_values() {
        const core::BasisRow values = core::basis_functions(frame_.curve.knots(), frame_.u).derivatives[0];
        const Notation& notation = frame_.state.view.notation;
        const double x = frame_.x(frame_.u);
        const bool is_right = x < 0.5 * (frame_.layout.left_px + frame_.layout.right_px);
        const double text_x = x + frame_.pen.px(is_right ? 9.0 : -9.0);
        const render::Anchor anchor = is_right ? render::Anchor::left : render::Anchor::right;
        double sum = 0.0;
        for (std::size_t j = 0; j < values.size(); ++j) {
            const double lower = frame_.y(sum);
            sum += values[j];
            const double upper = frame_.y(sum);
            frame_.pen.segment({x, lower}, {x, upper},
                               {.color = frame_.theme.point(frame_.hue(active_[j])), .width = 6.0});
            frame_.pen.segment({x - frame_.pen.px(6.0), upper}, {x + frame_.pen.px(6.0), upper},
                               {.color = frame_.theme.text, .width = 1.5});
            if (lower - upper < frame_.pen.px(least_area_height)) continue;
            named_.insert(active_[j]);
            row_.write(frame_.pen, {text_x, 0.5 * (lower + upper)},
                       core::sentence("{function} = {value}",
                                      {{"function", name(active_[j])}, {"value", exact_text(notation, values[j])}}),
                       {.color = frame_.theme.text, .anchor = anchor, .font = render::LabelFont::bold});
        }
        frame_.pen.text({text_x, frame_.y(1.0) - frame_.pen.px(11.0)},
                        core::sentence("sum {sum}", {{"sum", exact_text(notation, sum)}}),
                        {.color = frame_.theme.parameter, .anchor = anchor, .font = render::LabelFont::bold});
    }

    void draw_name(const NamePlace& place) {
        if (place.height < frame_.pen.px(least_area_height) || named_.contains(place.index)) return;
        if (frame_.layout.right_px - frame_.layout.left_px < frame_.pen.px(least_plot_width)) return;
        const TextStyle style{.color = frame_.theme.text, .anchor = render::Anchor::center};
        const double half = 0.5 * text_size(name(place.index), frame_.pen.px(style.size)).x + frame_.pen.px(4.0);
        const double x = std::clamp(place.middle.x, frame_.layout.left_px + half, frame_.layout.right_px - half);
        row_.write(frame_.pen, {x, place.middle.y}, name(place.index), style);
    }

    PlotFrame& frame_;
    std::vector<std::size_t> active_;
    std::map<std::size_t, NamePlace> widest_;  // by the function's number
    std::set<std::size_t> named_;              // those with a value
    TextRow row_;
};

std::vector<PlotInterval> intervals_of(const EditorState& state, const PlotLayout& layout) {
    const std::shared_ptr<const PlotBasis> basis = state.derived.plot_basis(state.active_curve()->knots());
    return plot_intervals(basis->knots(), layout.range, layout.right_px - layout.left_px,
                          area_spacing * state.view.interface_scale);
}

}  // namespace

bool shows_basis_areas(const EditorState& state, const PlotLayout& layout) {
    return state.view.overlays.is_shown(Overlay::basis_values) && !intervals_of(state, layout).empty();
}

void draw_basis_areas(PlotFrame& frame) {
    if (shows_recurrence(frame)) return;
    const std::vector<PlotInterval> intervals = intervals_of(frame.state, frame.layout);
    if (!intervals.empty()) AreaDrawing(frame).draw(intervals);
}

}  // namespace batten::editor
