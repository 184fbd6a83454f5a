/// The title of a figure, in lines that can be read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace batten::editor {

/// Lines one below the other; sizes are design pixels.
struct FigureTitle {
    std::vector<std::string> lines;  ///< of what the user wrote, formulas between dollar signs
    double size = 0.0;               ///< of the letters

    /// From line to line.
    double pitch() const;
    /// With what is free above and below; 0 without lines.
    double height() const;
};

/// The title in few lines of about the same length and large letters, 18 to 9 pixels high, at most six lines. It is
/// broken where it has a line break, else at blanks, and within a word only where that is longer than a line, but never
/// within a formula. None where it has no room on `width`, of which its margins are a part, or its lines are higher
/// than `most_height`. Cost: linear in the title.
std::optional<FigureTitle> fitted_title(std::string_view title, double width, double most_height);

}  // namespace batten::editor
