/// The parts of a label: text on the line, lower and higher parts.
#pragma once

#include <string_view>
#include <vector>

namespace batten::render {

enum class Script { none, sub, super };

struct LabelRun {
    std::string_view text;
    Script script = Script::none;
    bool is_stacked = false;  ///< begins where the run before does: "_{3}^{1}"
    double shift = 0.0;       ///< how far its line is below that of the text, as a part of the size of the text
};

/// The runs of a text in the notation of Label, in order; they refer to `text`. A part without its end reaches to the
/// end of the text.
std::vector<LabelRun> label_runs(std::string_view text);

/// The size of scripts, as a part of that of the text.
inline constexpr double script_size = 0.74;

/// How far the line on which letters stand is below the position of a label, as a part of the size of the text: half of
/// what the interface's fonts rise above it, less what they reach below.
inline constexpr double baseline_drop = 0.36;

}  // namespace batten::render
