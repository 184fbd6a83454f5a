#include "exchange/iges_reader.h"

#include <gtest/gtest.h>

#include "core/document/file_text.h"

namespace batten::exchange {

// OpenCASCADE takes what is missing for zeros, so it is not asked.
TEST(IgesReader, RefusesAFileThatIsCutOffAtAnyLine) {
    const std::string text = core::read_text(BATTEN_EXCHANGE_DATA "/freecad.igs").value();
    for (std::size_t end = text.find('\n'); end + 1 < text.size(); end = text.find('\n', end + 1)) {
        const auto cut = read_iges(std::string_view(text).substr(0, end + 1));
        ASSERT_FALSE(cut.has_value()) << end;
        EXPECT_EQ(cut.error().what, "the file ends without the line T that ends every IGES file; a part is missing");
    }
    EXPECT_FALSE(read_iges("").has_value());
}

TEST(IgesReader, RefusesAFileThatLacksALine) {
    const std::string text = core::read_text(BATTEN_EXCHANGE_DATA "/freecad.igs").value();
    std::size_t begin = 0;
    while (text[begin + 72] != 'P') begin = text.find('\n', begin) + 1;
    const std::string without = text.substr(0, begin) + text.substr(text.find('\n', begin) + 1);
    const auto refused = read_iges(without);
    ASSERT_FALSE(refused.has_value());
    EXPECT_TRUE(refused.error().what.starts_with("section P has ")) << refused.error().what;
}

}  // namespace batten::exchange
