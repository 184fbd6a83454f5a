/// What the joint tool does with the places that are clicked.
#pragma once

#include <optional>

#include "core/base/names.h"
#include "core/measure/meeting.h"
#include "core/shape/offset_shape.h"

namespace batten::editor {

enum class JointOperation { join, match, blend, fillet, chamfer, trim, extend, split, offset };

struct JointTool {
    JointOperation operation = JointOperation::join;
    core::GeometricContinuity continuity = core::GeometricContinuity::g2;
    std::optional<double> radius{};  ///< of fillets, and the distances of chamfers; none: a step of the grid
    bool offsets_both_sides = false;
    core::OffsetCorners corners = core::OffsetCorners::mitre;  ///< of offsets
    core::OffsetCaps caps = core::OffsetCaps::none;            ///< of those on both sides
};

/// Whether a second place is clicked.
constexpr bool takes_two_places(JointOperation operation) {
    return operation < JointOperation::trim || operation == JointOperation::extend;
}

/// Whether the first click does it.
constexpr bool takes_one_click(JointOperation operation) {
    return operation == JointOperation::trim || operation == JointOperation::split;
}

/// Whether it is about ends, else about any place of a curve.
constexpr bool takes_ends(JointOperation operation) {
    return operation <= JointOperation::blend;
}

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::JointOperation> {
    using enum editor::JointOperation;
    static constexpr std::array table{Named{join, "join", "join"},          Named{match, "match", "match"},
                                      Named{blend, "blend", "blend"},       Named{fillet, "fillet", "fillet"},
                                      Named{chamfer, "chamfer", "chamfer"}, Named{trim, "trim", "trim"},
                                      Named{extend, "extend", "extend"},    Named{split, "split", "split at crossings"},
                                      Named{offset, "offset", "offset"}};
};

}  // namespace batten::core
