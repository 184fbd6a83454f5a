#include "exchange/format.h"

#include <gtest/gtest.h>

namespace batten::exchange {

TEST(Formats, StandInTheOrderOfTheirNames) {
    ASSERT_EQ(all_formats().size(), core::Names<Format>::table.size());
    for (std::size_t i = 0; i < all_formats().size(); ++i)
        EXPECT_EQ(all_formats()[i].format, core::Names<Format>::table[i].value);
}

TEST(Formats, AreFoundByTheLongestEndingInAnyCase) {
    EXPECT_EQ(format_of("drawings/hull.DXF"), Format::dxf);
    EXPECT_EQ(format_of("hull.v2.stp"), Format::step);
    EXPECT_EQ(format_of("hull.tinyspline.json"), Format::tinyspline);
    EXPECT_EQ(format_of("hull.json"), std::nullopt);
    EXPECT_EQ(format_of("hull"), std::nullopt);
    EXPECT_EQ(format_of(".svg"), std::nullopt);
}

}  // namespace batten::exchange
