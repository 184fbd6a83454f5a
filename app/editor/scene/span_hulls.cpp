#include "app/editor/scene/span_hulls.h"

#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_hulls = 120;
constexpr double smallest_hull = 6.0;  // design pixels
constexpr double opacity = 0.10;
constexpr double opacity_of_many = 0.05;
constexpr std::size_t many = 12;
constexpr double outline_share = 0.7;

std::vector<std::size_t> hulled_spans(const CanvasFrame& frame, Thinned& hulls) {
    std::vector<std::size_t> spans;
    frame.kept->strips().visit_spans(frame.seen(0.0), frame.pen.px(smallest_hull) / frame.state.view.camera.scale,
                                     most_hulls, [&](std::size_t span, core::Point, std::size_t count) {
                                         spans.push_back(span);
                                         hulls.seen += count;
                                     });
    const std::size_t stride = spans.size() / most_hulls + 1;
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < spans.size(); k += stride) some.push_back(spans[k]);
    hulls.shown = some.size();
    return some;
}

std::vector<core::Point> hull_of(const core::Curve& curve, std::size_t span) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const auto control = curve.control_points();
    std::vector<core::Point> points;
    for (std::size_t i = span - p; i <= span; ++i) points.push_back(control[i % control.size()]);
    return core::convex_hull(points);
}

}  // namespace

Thinned draw_span_hulls(CanvasFrame& frame) {
    Thinned hulls;
    const std::vector<std::size_t> spans = hulled_spans(frame, hulls);
    const double share = spans.size() > many ? opacity_of_many : opacity;
    std::vector<std::vector<glm::dvec2>> outlines;
    for (const std::size_t span : spans) outlines.push_back(frame.screen(hull_of(*frame.curve, span)));
    const auto color = [&](std::size_t k) {
        return frame.theme.level(spans[k] - static_cast<std::size_t>(frame.curve->degree()) + 1);
    };
    for (std::size_t k = 0; k < outlines.size(); ++k) frame.pen.fill(outlines[k], render::faded(color(k), share));
    // Opaque, and all after the fills: so they are painted in one go.
    for (std::size_t k = 0; k < outlines.size(); ++k)
        frame.pen.outline(outlines[k],
                          {.color = render::blended(color(k), outline_share, frame.theme.canvas), .width = 1.25});
    return hulls;
}

}  // namespace batten::editor
