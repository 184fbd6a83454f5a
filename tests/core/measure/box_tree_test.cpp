#include "core/measure/detail/box_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace batten::core {
namespace {

Box box_about(Point center, double half) {
    return {center - Vector(half, half), center + Vector(half, half)};
}

double gap(double lower, double upper, double other_lower, double other_upper) {
    return std::max(lower - other_upper, other_lower - upper);
}

TEST(BoxTree, finds_what_a_look_at_all_finds) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> place(0.0, 10.0);
    for (const std::size_t n : {1UL, 2UL, 3UL, 7UL, 64UL, 65UL, 300UL}) {
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < n; ++i) boxes.push_back(box_about({place(engine), place(engine)}, 0.3));
        const BoxTree tree(boxes);
        for (int trial = 0; trial < 50; ++trial) {
            const Box box = box_about({place(engine), place(engine)}, 0.5);
            const double distance = 0.25;
            const std::size_t first = static_cast<std::size_t>(trial) % (n + 1);
            std::vector<std::size_t> expected;
            for (std::size_t i = first; i < n; ++i)
                if (gap(box.lower.x, box.upper.x, boxes[i].lower.x, boxes[i].upper.x) <= distance &&
                    gap(box.lower.y, box.upper.y, boxes[i].lower.y, boxes[i].upper.y) <= distance)
                    expected.push_back(i);
            std::vector<std::size_t> found;
            tree.each_near(box, distance, first, [&](std::size_t i) { found.push_back(i); });
            EXPECT_EQ(found, expected) << n << " boxes";
        }
    }
}

TEST(BoxTree, of_no_boxes_finds_none) {
    BoxTree({}).each_near(box_about({0, 0}, 1), 0.0, 0, [](std::size_t) { FAIL(); });
}

// A row of boxes each of which touches the next.
std::size_t boxes_looked_at(std::size_t n) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < n; ++i) boxes.push_back(box_about({static_cast<double>(i), 0.0}, 0.5));
    std::size_t asked = 0;
    BoxTree(boxes).each_near(
        box_about({0.4 * static_cast<double>(n), 0.0}, 0.1), 0.0, 0, [](std::size_t) {}, [&] { ++asked; });
    return asked;
}

TEST(BoxTree, looks_at_few_boxes) {
    const std::size_t of_thousand = boxes_looked_at(1 << 10);
    EXPECT_LE(of_thousand, 4 * 11);
    EXPECT_LE(boxes_looked_at(1 << 20), of_thousand + 4 * 10);
}

}  // namespace
}  // namespace batten::core
