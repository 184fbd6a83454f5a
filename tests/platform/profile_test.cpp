#include "app/platform/profile.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace batten::platform {

namespace {

using Json = nlohmann::json;

FrameCost cost_of(double input_ms, double draw_ms, std::size_t vertices) {
    FrameCost cost;
    cost.part_ms.front() = input_ms;
    cost.part_ms.back() = draw_ms;
    cost.vertices = vertices;
    return cost;
}

Profile sample() {
    return {{.file = "wave.json", .gesture = editor::ScriptedGesture::drag_knot, .frame_count = 3},
            {cost_of(1.0, 5.0, 30), cost_of(2.0, 1.0, 10), cost_of(3.0, 6.0, 20)},
            {cost_of(0.5, 1.0, 4), cost_of(0.25, 1.25, 4), cost_of(0.5, 1.5, 4)},
            120.5};
}

TEST(Profile, spreads_are_values_by_their_rank) {
    EXPECT_EQ(spread_of({7.0}).median, 7.0);
    EXPECT_EQ(spread_of({7.0}).p99, 7.0);
    EXPECT_EQ(spread_of({3.0, 1.0, 2.0}).median, 2.0);
    EXPECT_EQ(spread_of({4.0, 3.0, 1.0, 2.0}).median, 2.0);
    std::vector<double> values(200);
    std::iota(values.rbegin(), values.rend(), 1.0);
    EXPECT_EQ(spread_of(values).median, 100.0);
    EXPECT_EQ(spread_of(values).p99, 198.0);
}

TEST(Profile, as_json_has_all_parts_beside_the_empty_canvas) {
    std::ostringstream out;
    print_json(out, sample());
    const Json json = Json::parse(out.str());
    EXPECT_EQ(json["file"], "wave.json");
    EXPECT_EQ(json["gesture"], "drag-knot");
    EXPECT_EQ(json["frames"], 3);
    EXPECT_EQ(json["frame_ms"], (Json{{"median", 6.0}, {"p99", 9.0}}));
    EXPECT_EQ(json["parts_ms"].size(), 6U);
    EXPECT_EQ(json["parts_ms"]["input"], (Json{{"median", 2.0}, {"p99", 3.0}}));
    EXPECT_EQ(json["parts_ms"]["scene"], (Json{{"median", 0.0}, {"p99", 0.0}}));
    EXPECT_EQ(json["parts_ms"]["draw"], (Json{{"median", 5.0}, {"p99", 6.0}}));
    EXPECT_EQ(json["vertices"], (Json{{"median", 20.0}, {"p99", 30.0}}));
    EXPECT_EQ(json["empty"]["frame_ms"], (Json{{"median", 1.5}, {"p99", 2.0}}));
    EXPECT_EQ(json["ratio"], 4.0);
    EXPECT_EQ(json["start_ms"], 120.5);
}

TEST(Profile, as_text_says_the_same) {
    std::ostringstream out;
    print_text(out, sample());
    EXPECT_EQ(out.str(),
              "Drag a knot: 3 frames of wave.json, in milliseconds of processor time\n"
              "                  median   99 of 100   empty canvas   99 of 100\n"
              "  frame            6.000       9.000          1.500       2.000\n"
              "  input            2.000       3.000          0.500       0.500\n"
              "  commands         0.000       0.000          0.000       0.000\n"
              "  panels           0.000       0.000          0.000       0.000\n"
              "  scene            0.000       0.000          0.000       0.000\n"
              "  upload           0.000       0.000          0.000       0.000\n"
              "  draw             5.000       6.000          1.250       1.500\n"
              "  vertices            20          30              4           4\n"
              "A frame costs 4.00 times that of an empty canvas\n"
              "The first frame was shown after 120.500\n");
}

}  // namespace

}  // namespace batten::platform
