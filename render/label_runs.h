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
};

/// The runs of a text in the notation of Label, in order; they refer to `text`. A part without its end reaches to the
/// end of the text.
std::vector<LabelRun> label_runs(std::string_view text);

/// How scripts are set: their size, and how far their line is shifted down or up, as parts of the size of the text.
inline constexpr double script_size = 0.74;
inline constexpr double script_shift = 0.3;

/// How far the line on which letters stand is below the position of a label, as a part of the size of the text: half of
/// what the interface's fonts rise above it, less what they reach below.
inline constexpr double baseline_drop = 0.36;

}  // namespace batten::render
