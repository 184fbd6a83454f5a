/// What edits do to curves that are made of fit points.
#pragma once

#include "core/document/document.h"
#include "core/edit/plane_map.h"
#include "core/make/fit_points.h"

namespace batten::editor {

/// Gives the entry these points, and the curve through them. Errors: those of core::through_points.
[[nodiscard]] core::Result<void> set_fit(core::DocumentCurve& entry, core::FitPoints fit);

/// Maps the entry's curve. An affine map takes its fit points along and makes the curve anew of them; any other one
/// leaves an ordinary curve. Errors: those of core::transform and core::through_points.
[[nodiscard]] core::Result<void> map_entry(core::DocumentCurve& entry, const core::PlaneMap& map);

/// The fit points with places and handles mapped and the same parameters: through them goes the mapped curve. The map
/// is affine.
core::FitPoints mapped_fit(core::FitPoints fit, const core::PlaneMap& map);

}  // namespace batten::editor
