/// What a measuring command found: shown in the inspector, marked on the canvas, printed by the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace batten::editor {

struct EditorState;

/// "curvature", 0.25. The name is stable: it becomes a member of the JSON output.
struct FoundNumber {
    std::string name;
    double value = 0.0;
    bool operator==(const FoundNumber&) const = default;
};

/// One row of the result.
struct Finding {
    std::string label;                   ///< "inflection", "knot 0.5", "point with w = 2": what the row is
    std::optional<double> parameter{};   ///< u on the active curve
    std::optional<core::Point> point{};  ///< is marked on the canvas
    std::vector<FoundNumber> numbers{};  ///< in the order to be shown in
    std::string note{};                  ///< "C⁰ by its knots, G¹ by its shape"; may be empty
    bool operator==(const Finding&) const = default;
};

struct Findings {
    std::string title;    ///< "Inflections", the heading
    std::string summary;  ///< one sentence for the status bar: "wave has 3 inflections"
    std::vector<Finding> rows{};
    bool operator==(const Findings&) const = default;
};

/// Shows `findings` until the document changes, Escape is pressed or others take their place.
void show_findings(EditorState& state, Findings findings);

}  // namespace batten::editor
