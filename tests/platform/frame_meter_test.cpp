#include "app/platform/frame_meter.h"

#include <gtest/gtest.h>

namespace batten::platform {

namespace {

double part_ms(const FrameCost& cost, FramePart part) {
    return cost.part_ms.at(static_cast<std::size_t>(part));
}

TEST(FrameMeter, gives_all_time_to_the_part_that_it_was_spent_in) {
    double now_ms = 100.0;
    FrameMeter meter([&] { return now_ms; });
    now_ms += 1.0;
    meter.enter(FramePart::commands);
    now_ms += 2.0;
    meter.enter(FramePart::scene);
    now_ms += 4.0;
    meter.enter(FramePart::commands);
    now_ms += 8.0;
    const FrameCost cost = meter.take();
    EXPECT_EQ(part_ms(cost, FramePart::input), 1.0);
    EXPECT_EQ(part_ms(cost, FramePart::commands), 10.0);
    EXPECT_EQ(part_ms(cost, FramePart::scene), 4.0);
    EXPECT_EQ(part_ms(cost, FramePart::draw), 0.0);
    EXPECT_EQ(cost.total_ms(), 15.0);
}

TEST(FrameMeter, begins_each_frame_where_the_one_before_ended) {
    double now_ms = 0.0;
    FrameMeter meter([&] { return now_ms; });
    meter.add_vertices(7);
    meter.enter(FramePart::draw);
    now_ms = 3.0;
    EXPECT_EQ(meter.take().vertices, 7U);
    now_ms = 5.0;
    const FrameCost second = meter.take();
    EXPECT_EQ(second.total_ms(), 2.0);
    EXPECT_EQ(part_ms(second, FramePart::input), 2.0);
    EXPECT_EQ(second.vertices, 0U);
}

TEST(FrameMeter, reads_a_clock_that_never_goes_back) {
    const double before_ms = processor_ms();
    EXPECT_GE(processor_ms(), before_ms);
}

}  // namespace

}  // namespace batten::platform
