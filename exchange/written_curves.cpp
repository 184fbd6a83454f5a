#include "exchange/written_curves.h"

#include <algorithm>

#include "core/base/sentence.h"

namespace batten::exchange {

core::FileResult<std::vector<const core::DocumentCurve*>> visible_curves(const core::Document& document) {
    std::vector<const core::DocumentCurve*> curves;
    for (const core::DocumentCurve& entry : document.curves)
        if (entry.visible) curves.push_back(&entry);
    if (curves.empty()) return tl::unexpected(core::FileError{"", "no curve is visible; show one of them to write it"});
    return curves;
}

core::CurveDefinition full_definition(const core::Curve& curve) {
    core::CurveDefinition definition = curve.definition();
    const std::span<const double> knots = curve.knots().values();
    const std::size_t count = knots.size() - static_cast<std::size_t>(curve.degree()) - 1;
    const std::size_t n = definition.points.size();
    definition.knots.assign(knots.begin(), knots.end());
    definition.points.resize(count);
    definition.weights.assign(curve.weights().begin(), curve.weights().end());
    definition.weights.resize(count);
    for (std::size_t i = n; i < count; ++i) {
        definition.points[i] = definition.points[i - n];
        definition.weights[i] = definition.weights[i - n];
    }
    if (std::ranges::all_of(definition.weights, [](double w) { return w == 1.0; })) definition.weights.clear();
    if (definition.periodic) definition.kind = core::KnotKind::custom;
    definition.periodic = false;
    definition.tears = core::Tears::allow;
    return definition;
}

std::vector<std::string> parts_left_out(const core::Document& document) {
    std::vector<std::string> sentences;
    const auto hidden = static_cast<std::size_t>(
        std::ranges::count_if(document.curves, [](const core::DocumentCurve& entry) { return !entry.visible; }));
    if (hidden > 0)
        sentences.push_back(core::sentence({.one = "one curve was left out, since it is hidden",
                                            .many = "{count} curves were left out, since they are hidden"},
                                           hidden));
    if (!document.pictures.empty())
        sentences.push_back(core::sentence({.one = "one picture was left out; only curves are written",
                                            .many = "{count} pictures were left out; only curves are written"},
                                           document.pictures.size()));
    return sentences;
}

}  // namespace batten::exchange
