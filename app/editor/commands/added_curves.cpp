#include "app/editor/commands/added_curves.h"

#include <set>
#include <utility>

#include "app/editor/state/marked_ends.h"
#include "app/editor/state/symmetry_links.h"

namespace batten::editor {

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
