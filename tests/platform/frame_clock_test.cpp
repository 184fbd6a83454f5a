#include "app/platform/frame_clock.h"

#include <gtest/gtest.h>

namespace batten::platform {

namespace {

constexpr double frame = 1.0 / 60.0;

TEST(FrameClock, draws_nothing_while_nothing_happens) {
    FrameClock clock(frame);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(clock.seconds_to_wait(0.0), 0.0);
        clock.begin_frame(0.0);
    }
    EXPECT_TRUE(clock.is_settled());
    EXPECT_EQ(clock.seconds_to_wait(100.0), std::nullopt);
}

TEST(FrameClock, draws_three_frames_after_an_event) {
    FrameClock clock(frame);
    for (int i = 0; i < 3; ++i) clock.begin_frame(0.0);
    clock.note_activity();
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(clock.seconds_to_wait(5.0), 0.0);
        clock.begin_frame(5.0);
    }
    EXPECT_EQ(clock.seconds_to_wait(5.0), std::nullopt);
    EXPECT_EQ(clock.frame_count(), 6U);
}

TEST(FrameClock, paces_an_animation_to_the_display) {
    FrameClock clock(frame);
    clock.begin_frame(1.0);
    clock.note_animation();
    EXPECT_NEAR(*clock.seconds_to_wait(1.0 + 0.25 * frame), 0.75 * frame, 1e-12);
    EXPECT_EQ(clock.seconds_to_wait(1.0 + 2.0 * frame), 0.0);
}

TEST(FrameClock, keeps_the_pace_though_each_wait_ends_late) {
    constexpr double late = 0.001;
    FrameClock clock(frame);
    double now = 1.0;
    clock.note_animation();
    clock.begin_frame(now);
    for (int i = 0; i < 600; ++i) {
        clock.note_animation();
        now += *clock.seconds_to_wait(now) + late;
        clock.begin_frame(now);
    }
    EXPECT_NEAR(now - 1.0, 600 * frame, 2 * frame);
}

TEST(FrameClock, measures_frames_per_second_and_restarts_after_a_pause) {
    FrameClock clock(frame);
    double now = 1.0;
    for (int i = 0; i < 40; ++i) {
        clock.note_animation();
        const double elapsed = clock.begin_frame(now);
        EXPECT_NEAR(elapsed, i == 0 ? 0.0 : 0.025, 1e-12);
        now += 0.025;
    }
    EXPECT_NEAR(clock.frames_per_second(), 40.0, 0.5);
    clock.note_animation();
    EXPECT_EQ(clock.begin_frame(now + 10.0), 0.0);
}

}  // namespace

}  // namespace batten::platform
