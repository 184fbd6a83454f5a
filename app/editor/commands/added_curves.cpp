#include "app/editor/commands/added_curves.h"

#include <set>
#include <utility>

#include "app/editor/state/fit_curve.h"
#include "app/editor/state/marked_ends.h"
#include "app/editor/state/symmetry_links.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

namespace {

Outcome<void> scale_curves(core::Document& document, const core::PlaneMap& map, const Units& units) {
    for (core::DocumentCurve& entry : document.curves) {
        if (const auto mapped = map_entry(entry, map); !mapped)
            return tl::unexpected(core::sentence("'{name}' cannot be measured in {unit}: {problem}",
                                                 {{"name", entry.name},
                                                  {"unit", core::title_of(units->unit)},
                                                  {"problem", refusal_words(units, mapped.error())}}));
        if (entry.symmetry) entry.symmetry = mapped_symmetry(*entry.symmetry, map);
    }
    return {};
}

}  // namespace

double coordinate_factor(const Units& from, const Units& to) {
    if (!from || !to || (from->unit == to->unit && from->scale == to->scale)) return 1.0;
    return core::converted(to->scale, from->unit, to->unit) / from->scale;
}

Outcome<std::optional<std::string>> convert_units(core::Document& document, const Units& units) {
    const double factor = coordinate_factor(document.units, units);
    if (factor == 1.0) return std::nullopt;
    const core::PlaneMap map = core::scaling(factor, factor, {0.0, 0.0});
    if (auto scaled = scale_curves(document, map, units); !scaled) return tl::unexpected(std::move(scaled.error()));
    for (core::Guide& guide : document.guides) guide.point = core::mapped(map, guide.point);
    for (core::Picture& picture : document.pictures) {
        picture.position = core::mapped(map, picture.position);
        picture.scale *= factor;
    }
    document.units = units;
    return core::sentence("its coordinates were multiplied by {factor}, so that lengths stay what they are",
                          {{"factor", message_text(factor)}});
}

void add_curves(core::Document& document, std::vector<core::DocumentCurve> curves) {
    core::FreeNames names(document);
    const std::size_t first_group = free_group(document);
    const std::size_t first_joint = free_joint(document);
    for (core::DocumentCurve& curve : curves) {
        curve.name = names.take(curve.name);
        if (curve.symmetry) curve.symmetry->group += first_group;
        for (core::EndMark& mark : curve.joints.ends) mark.joint += first_joint;
        document.curves.push_back(std::move(curve));
    }
}

void tell_names_apart(core::Document& document) {
    core::FreeNames names(document);
    std::set<std::string> met;
    for (core::DocumentCurve& curve : document.curves)
        if (!met.insert(curve.name).second) curve.name = names.take(curve.name);
}

}  // namespace batten::editor
