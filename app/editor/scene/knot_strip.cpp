#include "app/editor/scene/knot_strip.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/editor/scene/ratio_bar.h"
#include "app/editor/scene/text_row.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double most_stacks_per_px = 0.25;  // knots for each pixel of the strip's width
constexpr double stack_cell = 5.0;           // for each of which a stack is shown, if they are too many
constexpr double value_size = 12.0;
constexpr double multiplicity_size = 10.5;

/// Of the run of equal knots that begins at stored knot `first`.
KnotStack stack_of(const PlotFrame& frame, std::size_t first) {
    const core::KnotVector& knots = frame.curve.knots();
    const std::span<const double> stored = knots.stored();
    const double value = stored[first];
    KnotStack stack;
    stack.value = value;
    stack.multiplicity = knots.multiplicity(value);
    stack.is_interior = knots.is_periodic() || (knots.domain().lower < value && value < knots.domain().upper);
    stack.is_chosen = frame.is_chosen(first);
    for (std::size_t i = first; i < stored.size() && stored[i] == value; ++i) {
        const double rise = static_cast<double>(i - first) * frame.layout.stack_px;
        stack.places.emplace_back(frame.x(value), frame.layout.strip_px - rise);
        stack.is_lit = stack.is_lit || std::binary_search(frame.lit.knots.begin(), frame.lit.knots.end(), i);
    }
    return stack;
}

/// Collects the stacks to be shown by the stored index of their first knot.
class StackPicker {
  public:
    explicit StackPicker(const PlotFrame& frame) : frame_(frame), stored_(frame.curve.knots().stored()) {
        const double margin = parameter_length(frame.layout.diamond_px);
        range_ = {frame.layout.range.lower - margin, frame.layout.range.upper + margin};
    }

    std::size_t count() const { return index_of_first(next_above(range_.upper)) - index_of_first(range_.lower); }

    void pick_all() {
        for (std::size_t i = index_of_first(range_.lower); i < stored_.size() && stored_[i] <= range_.upper;
             i = index_of_first(next_above(stored_[i])))
            firsts_.push_back(i);
    }

    /// One for each cell of a grid that lies still while the plot moves, and what matters.
    void pick_some() {
        const double cell = parameter_length(frame_.pen.px(stack_cell));
        const double start = std::floor(range_.lower / cell) * cell;
        for (double k = 0.0; start + k * cell <= range_.upper; k += 1.0)
            pick_in(start + k * cell, start + (k + 1.0) * cell);
        for (const std::size_t i : frame_.lit.knots) pick(i);
        for (const std::size_t i : frame_.chosen_knots) pick(i);
        const core::Interval domain = frame_.curve.domain();
        for (const double end : {domain.lower, domain.upper}) pick(index_of_first(end));
    }

    std::vector<std::size_t> take() {
        std::sort(firsts_.begin(), firsts_.end());
        firsts_.erase(std::unique(firsts_.begin(), firsts_.end()), firsts_.end());
        return std::move(firsts_);
    }

  private:
    double parameter_length(double px) const {
        return px * frame_.layout.range.length() / (frame_.layout.right_px - frame_.layout.left_px);
    }
    static double next_above(double value) { return std::nextafter(value, core::Box::infinity); }
    std::size_t index_of_first(double value) const {
        return static_cast<std::size_t>(std::lower_bound(stored_.begin(), stored_.end(), value) - stored_.begin());
    }
    void pick(std::size_t index) {
        if (index >= stored_.size() || !range_.contains(stored_[index])) return;
        firsts_.push_back(index_of_first(stored_[index]));
    }
    void pick_in(double lower, double upper) {
        const std::size_t i = index_of_first(std::max(lower, range_.lower));
        if (i < stored_.size() && stored_[i] < upper) pick(i);
    }

    const PlotFrame& frame_;
    std::span<const double> stored_;
    core::Interval range_;
    std::vector<std::size_t> firsts_;
};

/// Small enough that evenly spread stacks do not touch.
double diamond_radius_px(const PlotFrame& frame, std::size_t stack_count) {
    const double room =
        (frame.layout.right_px - frame.layout.left_px) / static_cast<double>(std::max<std::size_t>(1, stack_count));
    return std::clamp(0.42 * room, std::min(frame.pen.px(2.0), frame.layout.diamond_px), frame.layout.diamond_px);
}

Symbol diamond(const PlotFrame& frame, const KnotStack& stack, double radius) {
    const Theme& theme = frame.theme;
    const bool is_outside = !frame.curve.domain().contains(stack.value);
    Symbol symbol{.shape = render::MarkerShape::diamond,
                  .radius = radius,
                  .fill = theme.dim,
                  .outline = theme.text,
                  .outline_width = 1.5};
    if (stack.is_interior) symbol.fill = theme.panel;
    if (is_outside) {
        symbol.fill = render::blended(theme.dim, 0.35, theme.panel);
        symbol.outline = theme.dim;
    }
    if (stack.is_lit || stack.is_chosen) symbol.outline = theme.accent;
    if (stack.is_chosen) symbol.outline_width = 2.5;
    return symbol;
}

void draw_axis(PlotFrame& frame) {
    const PlotLayout& layout = frame.layout;
    const auto stretch = [&](core::Interval parameters, const Stroke& stroke) {
        if (const auto band = frame.band(parameters))
            frame.pen.segment({band->lower_px.x, layout.strip_px}, {band->upper_px.x, layout.strip_px}, stroke);
    };
    stretch(layout.range, {.color = frame.theme.line, .width = 2.0});
    stretch(frame.curve.domain(), {.color = frame.theme.line, .width = 4.0});
    for (const core::Interval& part : frame.lit.parts)
        stretch(part, {.color = render::blended(frame.theme.accent, 0.6, frame.theme.panel), .width = 4.0});
}

/// As many digits as tell places of the shown range apart, or a fraction that has no last digit.
std::string value_text(const PlotFrame& frame, double value) {
    if (value == 0.0) return "0";
    const double decades =
        std::floor(std::log10(std::abs(value))) - std::floor(std::log10(frame.layout.range.length()));
    return unrounded_text(frame.state.view.notation, value,
                          number_text(value, static_cast<int>(std::clamp(decades + 4.0, 4.0, 17.0))));
}

std::string detail_text(const PlotFrame& frame, const KnotStack& stack) {
    const int times = stack.multiplicity;
    if (stack.is_interior) {
        const std::string continuity = continuity_text(frame.curve.degree() - times);
        return times > 1 ? fmt::format("×{} {}", times, continuity) : continuity;
    }
    const bool is_end = frame.curve.domain().contains(stack.value);
    if (is_end && times > frame.curve.degree()) return core::sentence("×{times} clamped", {{"times", times}});
    return times > 1 ? fmt::format("×{}", times) : "";
}

/// Chosen knots first, then the domain's ends, then multiple knots.
int importance(const PlotFrame& frame, const KnotStack& stack) {
    if (stack.is_chosen) return 3;
    const core::Interval domain = frame.curve.domain();
    if (stack.value == domain.lower || stack.value == domain.upper) return 2;
    return stack.multiplicity > 1 ? 1 : 0;
}

}  // namespace

ShownStacks knot_stacks(const PlotFrame& frame) {
    StackPicker picker(frame);
    ShownStacks shown{.stacks = {}, .count = picker.count()};
    if (static_cast<double>(shown.count) <= most_stacks_per_px * frame.pen.size_px().x)
        picker.pick_all();
    else
        picker.pick_some();
    for (const std::size_t first : picker.take()) shown.stacks.push_back(stack_of(frame, first));
    return shown;
}

void draw_knot_strip(PlotFrame& frame, const std::vector<KnotStack>& stacks) {
    draw_axis(frame);
    const double radius = diamond_radius_px(frame, stacks.size()) / frame.pen.px(1.0);
    for (const bool chosen : {false, true})
        for (const KnotStack& stack : stacks)
            if (stack.is_chosen == chosen)
                for (const glm::dvec2 place : stack.places)
                    frame.pen.symbol(place, diamond(frame, stack, chosen ? std::max(radius, 6.0) : radius));
}

std::vector<std::string> draw_knot_labels(PlotFrame& frame, std::vector<KnotStack> stacks) {
    std::stable_sort(stacks.begin(), stacks.end(), [&](const KnotStack& a, const KnotStack& b) {
        return importance(frame, a) > importance(frame, b);
    });
    const double room = frame.layout.labels_px;
    TextRow values;
    TextRow details;
    std::vector<std::string> unplaced;
    for (const KnotStack& stack : stacks) {
        const double x = stack.places.front().x;
        const TextStyle value{.color = stack.is_chosen ? frame.theme.accent : frame.theme.text,
                              .size = value_size,
                              .anchor = render::Anchor::center};
        const std::string name = value_text(frame, stack.value);
        // A detail without its value would tell nothing.
        if (!values.write(frame.pen, {x, frame.layout.strip_px + 0.4 * room}, name, value)) {
            unplaced.push_back(name);
            continue;
        }
        const std::string text = detail_text(frame, stack);
        if (text.empty() || has_ratio_bar(frame)) continue;
        const TextStyle detail{.color = stack.is_chosen ? frame.theme.accent : frame.theme.dim,
                               .size = multiplicity_size,
                               .anchor = render::Anchor::center};
        details.write(frame.pen, {x, frame.layout.strip_px + 0.68 * room}, text, detail);
    }
    return unplaced;
}

void draw_knot_guides(PlotFrame& frame, const std::vector<KnotStack>& stacks) {
    for (const KnotStack& stack : stacks) {
        const double x = stack.places.front().x;
        if (!stack.is_chosen || x < frame.layout.left_px || x > frame.layout.right_px) continue;
        frame.pen.segment({x, frame.layout.top_px}, {x, frame.layout.strip_px},
                          {.color = frame.theme.accent, .width = 1.0, .dash = 3.0, .gap = 3.0});
    }
}

}  // namespace batten::editor
