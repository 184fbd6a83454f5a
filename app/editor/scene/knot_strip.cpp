#include "app/editor/scene/knot_strip.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/editor/formula.h"
#include "app/editor/scene/text_row.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double value_size = 12.0;
constexpr double multiplicity_size = 10.5;

/// The diamonds of equal knots.
struct Stack {
    double value = 0.0;
    int multiplicity = 1;
    bool is_interior = false;  ///< strictly inside the domain, or the seam of a periodic curve
    bool is_lit = false;
    bool is_chosen = false;
    std::vector<glm::dvec2> places;  ///< from the axis upwards
};

Stack stack_of(const PlotFrame& frame, const KnotMark& mark) {
    const core::KnotVector& knots = frame.curve.knots();
    const double value = knots.stored()[mark.index];
    Stack stack;
    stack.value = value;
    stack.multiplicity = knots.multiplicity(value);
    stack.is_interior = knots.is_periodic() || (knots.domain().lower < value && value < knots.domain().upper);
    stack.is_chosen = frame.is_chosen(mark.index);
    return stack;
}

std::vector<Stack> stacks(const PlotFrame& frame) {
    std::vector<Stack> all;
    const auto stored = frame.curve.knots().stored();
    for (const KnotMark& mark : knot_marks(frame.state, frame.layout)) {
        if (all.empty() || all.back().value != stored[mark.index]) all.push_back(stack_of(frame, mark));
        Stack& stack = all.back();
        stack.places.push_back(mark.center_px);
        stack.is_lit = stack.is_lit || std::binary_search(frame.lit.knots.begin(), frame.lit.knots.end(), mark.index);
    }
    return all;
}

/// Small enough that evenly spread stacks do not touch.
double diamond_radius_px(const PlotFrame& frame, std::size_t stack_count) {
    const double room =
        (frame.layout.right_px - frame.layout.left_px) / static_cast<double>(std::max<std::size_t>(1, stack_count));
    return std::clamp(0.42 * room, std::min(frame.pen.px(2.0), frame.layout.diamond_px), frame.layout.diamond_px);
}

Symbol diamond(const PlotFrame& frame, const Stack& stack, double radius) {
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

/// As many digits as tell places of the shown range apart.
std::string value_text(const PlotFrame& frame, double value) {
    if (value == 0.0) return "0";
    const double decades =
        std::floor(std::log10(std::abs(value))) - std::floor(std::log10(frame.layout.range.length()));
    return number_text(value, static_cast<int>(std::clamp(decades + 4.0, 4.0, 17.0)));
}

std::string detail_text(const PlotFrame& frame, const Stack& stack) {
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
int importance(const PlotFrame& frame, const Stack& stack) {
    if (stack.is_chosen) return 3;
    const core::Interval domain = frame.curve.domain();
    if (stack.value == domain.lower || stack.value == domain.upper) return 2;
    return stack.multiplicity > 1 ? 1 : 0;
}

}  // namespace

void draw_knot_strip(PlotFrame& frame) {
    draw_axis(frame);
    const std::vector<Stack> all = stacks(frame);
    const double radius = diamond_radius_px(frame, all.size()) / frame.pen.px(1.0);
    for (const bool chosen : {false, true})
        for (const Stack& stack : all)
            if (stack.is_chosen == chosen)
                for (const glm::dvec2 place : stack.places)
                    frame.pen.symbol(place, diamond(frame, stack, chosen ? std::max(radius, 6.0) : radius));
}

void draw_knot_labels(PlotFrame& frame) {
    std::vector<Stack> all = stacks(frame);
    std::stable_sort(all.begin(), all.end(),
                     [&](const Stack& a, const Stack& b) { return importance(frame, a) > importance(frame, b); });
    const double room = frame.pen.size_px().y - frame.layout.strip_px;
    TextRow values;
    TextRow details;
    for (const Stack& stack : all) {
        const double x = stack.places.front().x;
        const TextStyle value{.color = stack.is_chosen ? frame.theme.accent : frame.theme.text,
                              .size = value_size,
                              .anchor = render::Anchor::center};
        // A detail without its value would tell nothing.
        if (!values.write(frame.pen, {x, frame.layout.strip_px + 0.4 * room}, value_text(frame, stack.value), value))
            continue;
        const std::string text = detail_text(frame, stack);
        if (text.empty()) continue;
        const TextStyle detail{.color = stack.is_chosen ? frame.theme.accent : frame.theme.dim,
                               .size = multiplicity_size,
                               .anchor = render::Anchor::center};
        details.write(frame.pen, {x, frame.layout.strip_px + 0.68 * room}, text, detail);
    }
}

void draw_knot_guides(PlotFrame& frame) {
    for (const Stack& stack : stacks(frame)) {
        const double x = stack.places.front().x;
        if (!stack.is_chosen || x < frame.layout.left_px || x > frame.layout.right_px) continue;
        frame.pen.segment({x, frame.layout.top_px}, {x, frame.layout.strip_px},
                          {.color = frame.theme.accent, .width = 1.0, .dash = 3.0, .gap = 3.0});
    }
}

}  // namespace batten::editor
