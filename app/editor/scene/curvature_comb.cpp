#include "app/editor/scene/curvature_comb.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/pointer/comb_tooth.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tessellate.h"

namespace batten::editor {

namespace {

constexpr double tooth_spacing = 9.0;
constexpr double most_teeth = 400.0;  // in one run
constexpr std::size_t least_teeth_of_span = 5;
constexpr double most_teeth_per_px = 1.0;  // teeth for each pixel of the picture's width, where spans are many
constexpr double merged_teeth = 24.0;      // sixteen spans that are shorter together have one tooth

core::Side side_in(const core::Interval& span, double u) {
    return u < span.upper ? core::Side::right : core::Side::left;
}

/// Parameters lower + k * step for whole k: a power of two of them in the span, so that teeth stay where they are while
/// panning.
double tooth_step(const CanvasFrame& frame, const core::Interval& span) {
    constexpr int chords = 8;
    double length = 0.0;
    glm::dvec2 before = frame.screen(core::point_at(*frame.curve, span.lower));
    for (int k = 1; k <= chords; ++k) {
        const double u = k == chords ? span.upper : span.lower + span.length() * k / chords;
        const glm::dvec2 place = frame.screen(core::point_at(*frame.curve, u, side_in(span, u)));
        length += glm::distance(before, place);
        before = place;
    }
    const double halvings = std::ceil(std::log2(std::max(4.0, length / frame.pen.px(tooth_spacing))));
    return std::ldexp(span.length(), -static_cast<int>(std::min(halvings, 50.0)));
}

/// Draws teeth side by side.
class Comb {
  public:
    Comb(CanvasFrame& frame, const CombScale& scale)
        : frame_(frame),
          scale_(scale),
          line_{.color = frame.theme.resting_comb()},
          tips_line_{.color = frame.theme.comb, .width = 1.5} {}

    /// The teeth of a span from both one-sided values at its ends, as far as it is seen.
    void draw_span(const core::Interval& span, const core::Interval& seen) {
        double step = tooth_step(frame_, span);
        while (seen.length() / step > most_teeth) step *= 2.0;
        const double first = std::floor((seen.lower - span.lower) / step);
        const double last = std::ceil((seen.upper - span.lower) / step);
        for (double k = first; k <= last; k += 1.0) {
            const double u = span.clamp(span.lower + k * step);
            add_tooth(u, side_in(span, u));
        }
        end_tips();
    }

    void add_tooth(double u, core::Side side) {
        const auto tooth = tooth_at(*frame_.curve, u, side, scale_);
        if (!tooth) {
            end_tips();
            return;
        }
        const glm::dvec2 foot = frame_.screen(tooth->foot);
        const glm::dvec2 tip = tooth->tip(foot);
        frame_.pen.segment(foot, tip, line_);
        tips_.push_back(tip);
    }

    void end_tips() {
        frame_.pen.line(tips_, tips_line_);
        tips_.clear();
    }

  private:
    CanvasFrame& frame_;
    CombScale scale_;
    Stroke line_;
    Stroke tips_line_;
    std::vector<glm::dvec2> tips_;
};

/// A span that may be seen, standing for itself and those after it.
struct SeenSpan {
    std::size_t span = 0;
    std::size_t count = 1;
};

std::vector<SeenSpan> seen_spans(const CanvasFrame& frame, double longest_px) {
    std::vector<SeenSpan> spans;
    frame.kept->strips().visit_spans(frame.seen(longest_px), frame.pen.px(merged_teeth) / frame.state.view.camera.scale,
                                     most_candidates(frame), [&](std::size_t span, core::Point, std::size_t count) {
                                         spans.push_back({span, count});
                                     });
    return spans;
}

/// Each span by itself.
void draw_spans(CanvasFrame& frame, Comb& comb, const std::vector<SeenSpan>& spans, double longest_px) {
    const core::KnotVector& knots = frame.curve->knots();
    core::TessellationRequest seen{1.0 / frame.state.view.camera.scale, frame.seen(longest_px), {}};
    for (const SeenSpan& at : spans) {
        seen.range = {knots[at.span], knots[at.span + 1]};
        for (const auto& run : core::tessellate(*frame.curve, seen))
            comb.draw_span(seen.range, {run.front().u, run.back().u});
    }
}

/// One tooth at the beginning of as many spans as there is room for; returns how many.
std::size_t draw_starts(CanvasFrame& frame, Comb& comb, const std::vector<SeenSpan>& spans, std::size_t most) {
    const core::KnotVector& knots = frame.curve->knots();
    const std::size_t stride = spans.size() / most + 1;
    std::size_t next = 0;
    std::size_t teeth = 0;
    for (std::size_t k = 0; k < spans.size(); k += stride) {
        if (spans[k].span > next && k > 0) comb.end_tips();
        comb.add_tooth(knots[spans[k].span], core::Side::right);
        ++teeth;
        const SeenSpan& last = spans[std::min(k + stride, spans.size()) - 1];
        next = last.span + last.count;
    }
    comb.end_tips();
    return teeth;
}

}  // namespace

Thinned draw_curvature_comb(CanvasFrame& frame) {
    const auto scale = comb_scale(frame.state, *frame.curve, frame.state.view.shape.comb_factor);
    if (!scale) return {};
    Comb comb(frame, *scale);
    const std::vector<SeenSpan> spans = seen_spans(frame, scale->longest_px);
    const auto most = static_cast<std::size_t>(most_teeth_per_px * frame.pen.size_px().x) + 1;
    const bool are_single = std::all_of(spans.begin(), spans.end(), [](const SeenSpan& at) { return at.count == 1; });
    Thinned thinned;
    for (const SeenSpan& at : spans) thinned.seen += at.count;
    thinned.shown = thinned.seen;
    if (are_single && least_teeth_of_span * spans.size() <= most)
        draw_spans(frame, comb, spans, scale->longest_px);
    else
        thinned.shown = draw_starts(frame, comb, spans, most);
    return thinned;
}

void draw_comb_handle(CanvasFrame& frame) {
    const auto handle = comb_handle(frame.state, frame.state.view.shape.comb_factor);
    if (!handle || !frame.state.view.parts.window) return;
    const auto* hovered = std::get_if<HoveredHandle>(&frame.state.hover);
    const bool is_hovered = hovered != nullptr && hovered->handle == ViewHandle::comb;
    frame.keep_free(handle->place_px, 8.0);
    frame.pen.segment(handle->foot_px, handle->place_px, {.color = frame.theme.comb, .width = 2.5});
    frame.pen.symbol(handle->place_px, {.shape = render::MarkerShape::square,
                                        .radius = is_hovered ? 7.0 : 5.5,
                                        .fill = is_hovered ? frame.theme.accent : frame.theme.comb,
                                        .outline = frame.theme.canvas,
                                        .outline_width = 1.5});
}

}  // namespace batten::editor
