#include "app/editor/pointer/snap_text.h"

#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "app/editor/words/number_column.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {
namespace {

using core::sentence;

struct SnapTexts {
    std::string label;
    std::string sentence;
};

const std::string& name_of_curve(const core::Document& document, std::size_t index) {
    return document.curves[index].name;
}

std::string parameter_on(const core::Document& document, const SnapFound& found) {
    return parameter_text(*document.curves[found.thing].curve, found.number);
}

SnapTexts texts_of_point(const core::Document& document, const SnapFound& found) {
    const std::string point = point_text(found.index);
    if (found.thing == document.active) return {point, sentence("Snaps to {point}", {{"point", point}})};
    return {point, sentence("Snaps to {point} of '{curve}'",
                            {{"point", point}, {"curve", name_of_curve(document, found.thing)}})};
}

SnapTexts texts_of_end(const core::Document& document, const SnapFound& found) {
    const bool is_start = found.number == document.curves[found.thing].curve->domain().lower;
    return {is_start ? "start" : "end",
            sentence(is_start ? "Snaps to the start of '{curve}'" : "Snaps to the end of '{curve}'",
                     {{"curve", name_of_curve(document, found.thing)}})};
}

SnapTexts texts_of_crossing(const core::Document& document, const SnapFound& found) {
    if (found.guide)
        return {"crossing", sentence("Snaps to where '{curve}' crosses a guide",
                                     {{"curve", name_of_curve(document, found.thing)}})};
    if (found.thing == found.other)
        return {"crossing",
                sentence("Snaps to where '{curve}' crosses itself", {{"curve", name_of_curve(document, found.thing)}})};
    return {"crossing", sentence("Snaps to where '{curve}' and '{other}' cross",
                                 {{"curve", name_of_curve(document, found.thing)},
                                  {"other", name_of_curve(document, found.other)}})};
}

std::string guide_place_text(const core::Document& document, double world) {
    return with_unit(document.units, number_text(in_units(document.units, world)));
}

SnapTexts texts_of_guide(const core::Document& document, const SnapFound& found) {
    if (found.is_crossing) return {"guides", "Snaps to where two guides cross"};
    const core::Guide& guide = document.guides[found.thing];
    if (guide.angle == 0.0)
        return {"guide", sentence("Snaps to the guide y = {y}", {{"y", guide_place_text(document, guide.point.y)}})};
    if (guide.angle == 90.0)
        return {"guide", sentence("Snaps to the guide x = {x}", {{"x", guide_place_text(document, guide.point.x)}})};
    return {"guide", sentence("Snaps to the guide at {angle}°", {{"angle", number_text(guide.angle)}})};
}

SnapTexts snap_texts(const core::Document& document, const SnapFound& found) {
    const auto with_curve = [&](const char* text) {
        return sentence(text, {{"curve", name_of_curve(document, found.thing)}});
    };
    switch (found.kind) {
        case SnapKind::grid:
            return {"grid", "Snaps to the grid"};
        case SnapKind::guides:
            return texts_of_guide(document, found);
        case SnapKind::points:
            return texts_of_point(document, found);
        case SnapKind::knots:
            return {sentence("knot {u}", {{"u", parameter_on(document, found)}}),
                    sentence("Snaps to the knot {u} of '{curve}'",
                             {{"u", parameter_on(document, found)}, {"curve", name_of_curve(document, found.thing)}})};
        case SnapKind::ends:
            return texts_of_end(document, found);
        case SnapKind::midpoints:
            return {"midpoint", sentence("Snaps to the middle between {point} and {next}",
                                         {{"point", point_text(found.index)}, {"next", point_text(found.other)}})};
        case SnapKind::curve:
            return {"curve", with_curve("Snaps to the nearest place of '{curve}'")};
        case SnapKind::perpendicular:
            return {"perpendicular",
                    with_curve("Snaps to where the line from the start is perpendicular to '{curve}'")};
        case SnapKind::tangent:
            return {"tangent", with_curve("Snaps to where the line from the start touches '{curve}'")};
        case SnapKind::intersections:
            return texts_of_crossing(document, found);
        case SnapKind::angles:
            break;
    }
    return {sentence("{angle}°", {{"angle", number_text(found.number)}}),
            sentence("Snaps to the direction {angle}°", {{"angle", number_text(found.number)}})};
}

}  // namespace

Snap snap_of(const core::Document& document, const SnapFound& found) {
    SnapTexts texts = snap_texts(document, found);
    return {found.position, found.kind, std::move(texts.label), std::move(texts.sentence), found.lines};
}

}  // namespace batten::editor
