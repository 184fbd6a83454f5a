/// The place that a gesture is about: where it is, what it snaps to, and what is typed for it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/state/snap_kind.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// A line of the world that tells why something snaps.
struct SnapLine {
    core::Point from{};
    core::Point to{};
    bool operator==(const SnapLine&) const = default;
};

/// What the pointer snaps to.
struct Snap {
    core::Point position{};  ///< exact
    SnapKind kind = SnapKind::grid;
    std::string label;            ///< "P_{3}", beside its mark
    std::string sentence;         ///< "Snaps to P_{3}", for the status bar
    std::vector<SnapLine> lines;  ///< that belong to it
    bool operator==(const Snap&) const = default;
};

/// What the numbers that are typed for a gesture say.
enum class TypedFor {
    place,     ///< where it is
    factors,   ///< by how much something is scaled along x and y, "1.5" or "150%"
    angle,     ///< by how many degrees something is turned or sheared
    radius,    ///< how large an arc is
    distance,  ///< how far something is from what it goes along
    sides,     ///< how far from a corner it is cut, along the one side and, if that differs, along the other
    x,         ///< where an upright line is
    y          ///< where a level line is
};

/// Where a gesture puts something, as it was asked last.
struct ShownPlace {
    core::Point position{};
    std::optional<core::Point> from;  ///< what lengths and angles are measured from
    std::optional<Snap> snap;
    TypedFor typed_for = TypedFor::place;
    std::string reading{};  ///< what stands beside the pointer in place of where it is
    bool operator==(const ShownPlace&) const = default;
};

/// The numbers that are typed for a place, as texts: length and angle, or dx and dy; in the first field also a whole
/// place, as typed_place.h says.
struct TypedPlace {
    bool has_offsets = false;  ///< dx and dy
    std::array<std::string, 2> texts{};
    std::size_t active = 0;  ///< the field that keys go to
    bool operator==(const TypedPlace&) const = default;

    bool is_empty() const { return *this == TypedPlace{}; }
};

struct Placing {
    std::optional<ShownPlace> place;  ///< none where nothing is being placed
    TypedPlace typed;
};

}  // namespace batten::editor
