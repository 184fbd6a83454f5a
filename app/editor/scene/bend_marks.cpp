#include "app/editor/scene/bend_marks.h"

#include "app/editor/cards/card_texts.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_named = 24;
constexpr double text_height = 12.5;

std::size_t span_count(const core::Curve& curve) {
    return curve.knots().size() - 2 * static_cast<std::size_t>(curve.degree()) - 1;
}

/// The parameters of the spans in the picture, neighbors together; none where they are too many.
std::vector<core::Interval> searched_ranges(const CanvasFrame& frame) {
    if (is_searched_whole(*frame.curve)) return {frame.curve->domain()};
    const core::KnotVector& knots = frame.curve->knots();
    std::vector<core::Interval> ranges;
    std::size_t seen = 0;
    frame.kept->strips().visit_spans(frame.seen(0.0), 0.0, most_bent_spans,
                                     [&](std::size_t span, core::Point, std::size_t count) {
                                         seen += count;
                                         const double end = knots[std::min(span + count, knots.size() - 1)];
                                         if (!ranges.empty() && ranges.back().upper == knots[span])
                                             ranges.back().upper = end;
                                         else if (knots[span] < end)
                                             ranges.push_back({knots[span], end});
                                     });
    if (seen > most_bent_spans) return {};
    return ranges;
}

void name(CanvasFrame& frame, glm::dvec2 place, std::string text) {
    frame.keep_free(place, 6.0);
    frame.labels.push_back({.place = place,
                            .words = {{std::move(text), {.color = frame.theme.text, .size = text_height}}},
                            .distance = 11.0,
                            .crowding = Crowding::cover_symbols,
                            .farthest = 23.0,
                            .has_ground = true});
}

void mark_inflection(CanvasFrame& frame, const core::Inflection& inflection, bool has_name) {
    const glm::dvec2 place = frame.screen(inflection.point);
    frame.pen.symbol(place,
                     {.radius = 6.0, .fill = frame.theme.canvas, .outline = frame.theme.comb, .outline_width = 2.5});
    if (has_name) name(frame, place, inflection.is_jump ? "κ changes sign" : "κ = 0");
}

void mark_extremum(CanvasFrame& frame, const core::CurvatureExtremum& extremum, bool has_name) {
    const glm::dvec2 place = frame.screen(extremum.point);
    frame.pen.symbol(place, {.shape = render::MarkerShape::square,
                             .radius = 5.0,
                             .fill = frame.theme.comb,
                             .outline = frame.theme.canvas,
                             .outline_width = 1.5});
    const char* pattern = extremum.is_maximum ? "max κ = {curvature}" : "min κ = {curvature}";
    if (has_name)
        name(frame, place,
             core::sentence(pattern,
                            {{"curvature", short_text(frame.state.view.notation,
                                                      in_units(frame.state.shown().units, extremum.curvature, -1))}}));
}

}  // namespace

bool is_searched_whole(const core::Curve& curve) {
    return span_count(curve) <= most_bent_spans;
}

void draw_bend_marks(CanvasFrame& frame) {
    const auto bends = frame.state.measured.bends(*frame.curve, searched_ranges(frame));
    const bool have_names = bends->inflections.size() + bends->extrema.size() <= most_named;
    for (const core::CurvatureExtremum& extremum : bends->extrema) mark_extremum(frame, extremum, have_names);
    for (const core::Inflection& inflection : bends->inflections) mark_inflection(frame, inflection, have_names);
}

}  // namespace batten::editor
