#include "app/editor/scene/curvature_comb.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/evaluate.h"
#include "core/evaluate/tessellate.h"

namespace batten::editor {

namespace {

constexpr double tooth_length = 60.0;    // of the large curvature
constexpr double longest_tooth = 180.0;  // near cusps
constexpr double tooth_spacing = 9.0;
constexpr double most_teeth = 400.0;  // in one run

/// The non-empty spans of the domain.
std::vector<core::Interval> spans_of(const core::Curve& curve) {
    std::vector<core::Interval> spans;
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
        if (knots[s] < knots[s + 1]) spans.push_back({knots[s], knots[s + 1]});
    return spans;
}

core::Side side_in(const core::Interval& span, double u) {
    return u < span.upper ? core::Side::right : core::Side::left;
}

/// The curvature that nine tenths of the curve stay below; 0 for a straight line.
double large_curvature(const core::Curve& curve, const std::vector<core::Interval>& spans) {
    const int samples = std::clamp(256 / static_cast<int>(spans.size()), 3, 24);
    std::vector<double> values;
    for (const core::Interval& span : spans)
        for (int k = 0; k < samples; ++k) {
            const double u = span.lower + (k + 0.5) / samples * span.length();
            if (const auto value = core::curvature_at(curve, u)) values.push_back(std::abs(*value));
        }
    if (values.empty()) return 0.0;
    const auto rank = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
    std::nth_element(values.begin(), rank, values.end());
    return *rank;
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

/// The comb over one span.
class SpanComb {
  public:
    SpanComb(CanvasFrame& frame, const core::Interval& span, double px_per_curvature)
        : frame_(frame),
          span_(span),
          px_per_curvature_(px_per_curvature),
          line_{.color = frame.theme.resting_comb()},
          tips_line_{.color = frame.theme.comb, .width = 1.5} {}

    void draw(const core::Interval& seen) {
        double step = tooth_step(frame_, span_);
        while (seen.length() / step > most_teeth) step *= 2.0;
        const double first = std::floor((seen.lower - span_.lower) / step);
        const double last = std::ceil((seen.upper - span_.lower) / step);
        for (double k = first; k <= last; k += 1.0) add_tooth(span_.clamp(span_.lower + k * step));
        end_tips();
    }

  private:
    void add_tooth(double u) {
        const core::Side side = side_in(span_, u);
        const auto curvature = core::curvature_at(*frame_.curve, u, side);
        if (!curvature || !std::isfinite(*curvature)) {
            end_tips();
            return;
        }
        const core::Jet at = core::derivatives_at(*frame_.curve, u, 1, side);
        const core::Vector tangent = at[1] / core::length(at[1]);
        const glm::dvec2 right_in_picture{tangent.y, tangent.x};
        const double longest = frame_.pen.px(longest_tooth);
        const double length = std::clamp(*curvature * px_per_curvature_, -longest, longest);
        const glm::dvec2 foot = frame_.screen(at.point);
        const glm::dvec2 tip = foot + length * right_in_picture;
        frame_.pen.segment(foot, tip, line_);
        tips_.push_back(tip);
    }

    void end_tips() {
        frame_.pen.line(tips_, tips_line_);
        tips_.clear();
    }

    CanvasFrame& frame_;
    const core::Interval& span_;
    double px_per_curvature_;
    Stroke line_;
    Stroke tips_line_;
    std::vector<glm::dvec2> tips_;
};

}  // namespace

void draw_curvature_comb(CanvasFrame& frame) {
    const std::vector<core::Interval> spans = spans_of(*frame.curve);
    const double large = large_curvature(*frame.curve, spans);
    if (!(large > 0.0) || !std::isfinite(large)) return;
    const double px_per_curvature = frame.pen.px(tooth_length) / large;
    const core::TessellationRequest request{
        1.0 / frame.state.view.camera.scale, frame.seen(frame.pen.px(longest_tooth)), {}};
    for (const core::Interval& span : spans) {
        core::TessellationRequest seen = request;
        seen.range = span;
        SpanComb comb(frame, span, px_per_curvature);
        for (const auto& run : core::tessellate(*frame.curve, seen)) comb.draw({run.front().u, run.back().u});
    }
}

}  // namespace batten::editor
