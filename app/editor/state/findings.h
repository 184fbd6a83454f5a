/// What a measuring command found: shown in the inspector, marked on the canvas, printed by the command line.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/words/length.h"
#include "app/editor/words/number_column.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct EditorState;

/// "curvature", 0.25. The name is stable: it becomes a member of the JSON output.
struct FoundNumber {
    std::string name;
    double value = 0.0;
    double error = 0.0;  ///< by rounding; what is not above it is shown as zero
    int power = 0;       ///< of a length: 1 of one, 2 of an area, -1 of a curvature, 0 of what has no unit
    bool operator==(const FoundNumber&) const = default;
};

/// One row of the result, in the world.
struct Finding {
    std::string label;                   ///< "inflection", "knot 0.5", "point with w = 2": what the row is
    std::optional<double> parameter{};   ///< u on the active curve
    std::optional<core::Point> point{};  ///< is marked on the canvas
    std::vector<FoundNumber> numbers{};  ///< in the order to be shown in
    std::string note{};                  ///< "C⁰ by its knots, G¹ by its shape"; may be empty
    bool operator==(const Finding&) const = default;
};

/// How the numbers of all rows are written, one quantity alike in all of them.
struct FindingColumns {
    NumberColumn parameter;
    NumberColumn coordinate;
    std::map<std::string, NumberColumn> numbers;  ///< by their names
    bool operator==(const FindingColumns&) const = default;
};

struct Findings {
    std::string title;    ///< "Inflections", the heading
    std::string summary;  ///< one sentence for the status bar: "wave has 3 inflections"
    std::vector<Finding> rows{};
    double coordinate_error = 0.0;  ///< by rounding, of points on the curve
    Units units{};                  ///< in which people read it; set by show_findings
    FindingColumns columns{};       ///< made by show_findings
    bool operator==(const Findings&) const = default;
};

/// "C⁰ by its knots   (1, 2)   curvature 0.25": a row as it is read beside its label.
std::string details_text(const Findings& findings, const Finding& row);

/// A row with all digits, a line for each number, as it is copied.
std::string full_text(const Findings& findings, const Finding& row);

/// Shows `findings` until the document changes, Escape is pressed or others take their place.
void show_findings(EditorState& state, Findings findings);

}  // namespace batten::editor
