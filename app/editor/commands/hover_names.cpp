#include "app/editor/commands/hover_names.h"

#include <array>

#include "app/editor/commands/active_curve.h"

namespace batten::editor {

namespace {

using Values = std::vector<double>;

std::size_t index(const Values& values, std::size_t i) {
    return static_cast<std::size_t>(values[i]);
}

template <class Hovered>
Hover with_index(const Values& values) {
    return Hovered{index(values, 0)};
}

template <class Hovered>
Hover alone(const Values&) {
    return Hovered{};
}

struct HoverKind {
    const char* name;
    std::size_t value_count;
    bool has_indices;
    Hover (*make)(const Values&);
};

constexpr std::array kinds{
    HoverKind{"none", 0, true, alone<HoveredNothing>},
    HoverKind{"point", 1, true, with_index<HoveredPoint>},
    HoverKind{"ring", 1, true, with_index<HoveredWeightRing>},
    HoverKind{"knot", 1, true, with_index<HoveredKnot>},
    HoverKind{"span", 1, true, with_index<HoveredSpan>},
    HoverKind{"cell", 2, true,
              [](const Values& v) -> Hover {
                  return HoveredCell{index(v, 0), index(v, 1)};
              }},
    HoverKind{"parameter", 0, true, alone<HoveredParameter>},
    HoverKind{"curve", 1, false, [](const Values& v) -> Hover { return HoveredCurve{v[0]}; }},
    HoverKind{"leg", 1, true, with_index<HoveredLeg>},
    HoverKind{"other", 1, true, with_index<HoveredOtherCurve>},
    HoverKind{"basis", 1, true, with_index<HoveredBasis>},
};

Outcome<Hover> hover_of(const HoverKind& kind, const Values& values) {
    if (values.size() != kind.value_count)
        return tl::unexpected(std::string(kind.name) + " needs " + std::to_string(kind.value_count) + " numbers; " +
                              std::to_string(values.size()) + " were given");
    for (const double value : values) {
        const Outcome<std::size_t> checked = index_of(value, kind.name);
        if (kind.has_indices && !checked) return tl::unexpected(checked.error());
    }
    return kind.make(values);
}

}  // namespace

Outcome<Hover> hover_named(const std::string& kind, const std::vector<double>& values) {
    for (const HoverKind& known : kinds)
        if (kind == known.name) return hover_of(known, values);
    return tl::unexpected("nothing called '" + kind + "' can be under the pointer");
}

}  // namespace batten::editor
