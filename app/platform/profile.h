/// What a gesture costs in the real window, beside the same gesture on an empty canvas.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "app/editor/pointer/gesture_script.h"
#include "app/platform/frame_meter.h"

namespace batten::platform {

struct ProfileOptions {
    std::filesystem::path file;
    editor::ScriptedGesture gesture = editor::ScriptedGesture::drag;
    std::size_t frame_count = 1;          ///< at least 1
    std::vector<std::string> commands{};  ///< run before the gesture, as typed in the palette
};

/// The frames measured, of the file and before that without a curve.
struct Profile {
    ProfileOptions options;
    std::vector<FrameCost> frames;
    std::vector<FrameCost> empty_frames;
    double start_ms = 0.0;  ///< processor time from the start of the process to the end of its first frame
};

/// The frame whose cost stands at the middle of all, and the one that 99 of 100 do not exceed.
struct Spread {
    double median = 0.0;
    double p99 = 0.0;
};

/// Of at least one value. The value of rank ⌈n/2⌉ and that of rank ⌈99 n/100⌉, counted from 1 in ascending order.
Spread spread_of(std::vector<double> values);

/// As a table for people, or as JSON.
void print_text(std::ostream& out, const Profile& profile);
void print_json(std::ostream& out, const Profile& profile);

}  // namespace batten::platform
