#include "app/platform/frame_clock.h"

#include <algorithm>

namespace batten::platform {

namespace {

/// A longer gap between two frames is a pause, not a slow frame.
constexpr double pause_seconds = 0.25;
constexpr double measure_seconds = 0.5;

}  // namespace

std::optional<double> FrameClock::seconds_to_wait(double now) const {
    if (frames_due_ > 0 && !is_animating_) return 0.0;
    if (!is_animating_) return std::nullopt;
    return std::max(0.0, due_ - now);
}

double FrameClock::begin_frame(double now) {
    const double elapsed = now - last_begin_;
    const bool continues = was_animating_ && elapsed < pause_seconds;
    was_animating_ = is_animating_;
    is_animating_ = false;
    frames_due_ = std::max(0, frames_due_ - 1);
    last_begin_ = now;
    // Frames are due by the clock and not by the last frame's start, so that waking a little late each time does not
    // slow them.
    due_ = continues && now < due_ + frame_seconds_ ? due_ + frame_seconds_ : now + frame_seconds_;
    ++frame_count_;
    if (!continues) {
        measure_begin_ = now;
        measured_frames_ = 0;
        return 0.0;
    }
    ++measured_frames_;
    if (now - measure_begin_ >= measure_seconds) {
        frames_per_second_ = measured_frames_ / (now - measure_begin_);
        measure_begin_ = now;
        measured_frames_ = 0;
    }
    return elapsed;
}

}  // namespace batten::platform
