/// Decides when the next frame is due and measures how many are drawn.
#pragma once

#include <cstddef>
#include <optional>

namespace batten::platform {

/// Times are seconds of one steady clock.
class FrameClock {
  public:
    explicit FrameClock(double frame_seconds) : frame_seconds_(frame_seconds) {}

    /// Something happened: the interface needs this frame and two more to settle.
    void note_activity() { frames_due_ = 3; }

    /// Something moves by itself during the next frame.
    void note_animation() { is_animating_ = true; }

    /// How long to sleep before the next frame: 0 when it is due, none until something happens.
    std::optional<double> seconds_to_wait(double now) const;

    /// A frame begins; returns the seconds since the one before, 0 after a pause.
    double begin_frame(double now);

    /// Over the last second of uninterrupted movement; 0 before there is one.
    double frames_per_second() const { return frames_per_second_; }

    bool is_settled() const { return frames_due_ == 0 && !is_animating_; }
    std::size_t frame_count() const { return frame_count_; }

  private:
    double frame_seconds_;
    int frames_due_ = 3;
    bool is_animating_ = false;
    bool was_animating_ = false;
    double last_begin_ = 0.0;
    double due_ = 0.0;
    double measure_begin_ = 0.0;
    int measured_frames_ = 0;
    double frames_per_second_ = 0.0;
    std::size_t frame_count_ = 0;
};

}  // namespace batten::platform
