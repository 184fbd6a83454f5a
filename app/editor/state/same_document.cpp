#include "app/editor/state/same_document.h"

#include <algorithm>

#include "core/make/fit_points.h"

namespace batten::editor {

namespace {

bool is_same_fit(const std::shared_ptr<const core::FitPoints>& a, const std::shared_ptr<const core::FitPoints>& b) {
    return a == b || (a != nullptr && b != nullptr && *a == *b);
}

bool is_same_curve(const core::DocumentCurve& a, const core::DocumentCurve& b) {
    return (a.curve == b.curve || *a.curve == *b.curve) && a.name == b.name && a.color == b.color &&
           a.visible == b.visible && a.locked == b.locked && a.tears == b.tears && a.pinned == b.pinned &&
           a.symmetry == b.symmetry && a.group == b.group && a.joints == b.joints &&
           a.unknown_members == b.unknown_members && a.unknown_fit_members == b.unknown_fit_members &&
           is_same_fit(a.fit, b.fit);
}

}  // namespace

bool has_same_content(const core::Document& a, const core::Document& b) {
    return a.title == b.title && a.description == b.description && a.view == b.view && a.guides == b.guides &&
           a.units == b.units && a.unknown_members == b.unknown_members && a.pictures == b.pictures &&
           std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(), is_same_curve);
}

bool is_same_document(const core::Document& a, const core::Document& b) {
    return a.active == b.active && has_same_content(a, b);
}

}  // namespace batten::editor
