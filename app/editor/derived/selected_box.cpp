#include "app/editor/derived/selected_box.h"

#include <algorithm>

#include "app/editor/state/selected_parts.h"
#include "core/curve/control_box.h"

namespace batten::editor {

namespace {

core::Box box_of_parts(const SelectedParts& parts, const core::Document& document) {
    core::Box box;
    for (const SelectedPart& part : parts) {
        const core::Curve& curve = *document.curves[part.curve].curve;
        for (const std::size_t i : part.points) box.include(curve.control_points()[i]);
        if (!part.is_whole()) continue;
        const core::Box whole = core::control_box(curve);
        box.include(whole.lower);
        box.include(whole.upper);
    }
    return box;
}

}  // namespace

bool KeptSelection::is_of(const Selection& selection, const core::Document& document) const {
    const auto is_same_curve = [&](const SelectedPart& part, const std::shared_ptr<const core::Curve>& curve) {
        return part.curve < document.curves.size() && document.curves[part.curve].curve == curve;
    };
    return kept_ != nullptr && active_ == document.active && std::ranges::equal(kept_->parts, curves_, is_same_curve) &&
           selection_ == selection;
}

std::shared_ptr<const SelectedBox> KeptSelection::of(const Selection& selection, const core::Document& document) const {
    if (is_of(selection, document)) return kept_;
    SelectedParts parts = selected_parts(selection, document.active);
    const core::Box box = box_of_parts(parts, document);
    curves_.clear();
    for (const SelectedPart& part : parts) curves_.push_back(document.curves[part.curve].curve);
    selection_ = selection;
    active_ = document.active;
    kept_ = std::make_shared<const SelectedBox>(SelectedBox{std::move(parts), box});
    return kept_;
}

}  // namespace batten::editor
