/// The map by which the view of invariance maps the curve: one of a few, and how strong it is.
#pragma once

#include <string>

#include "core/base/names.h"
#include "core/edit/plane_map.h"

namespace batten::editor {

enum class ShownMapKind { rotate, scale, stretch, shear, mirror, project };
inline constexpr std::array all_shown_maps{ShownMapKind::rotate, ShownMapKind::scale,  ShownMapKind::stretch,
                                           ShownMapKind::shear,  ShownMapKind::mirror, ShownMapKind::project};

struct ShownMap {
    ShownMapKind kind = ShownMapKind::rotate;
    double amount = 30.0;  ///< degrees, a factor, or for a projection the part by which weights change at most
    bool operator==(const ShownMap&) const = default;
};

/// What a map of this kind is shown with at first; by how much it is made stronger; what it may be.
double usual_amount(ShownMapKind kind);
double amount_step(ShownMapKind kind);
core::Interval amounts_of(ShownMapKind kind);

/// Of a curve whose control points lie in `box`: about its middle; a projection takes no point of it to infinity.
core::PlaneMap map_over(const ShownMap& shown, const core::Box& box);

/// "Rotation by 30°".
std::string map_words(const ShownMap& shown);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::ShownMapKind> {
    using enum editor::ShownMapKind;
    static constexpr std::array table{Named{rotate, "rotate", "Rotate"},    Named{scale, "scale", "Scale"},
                                      Named{stretch, "stretch", "Stretch"}, Named{shear, "shear", "Shear"},
                                      Named{mirror, "mirror", "Mirror"},    Named{project, "project", "Project"}};
};

}  // namespace batten::core
