// A file with everything that the format has, cut off at every byte, and changed at every third.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/document/native_file.h"

namespace batten::core {
namespace {

std::string everything() {
    std::ifstream file(std::string(BATTEN_VERSIONS) + "/2026-11-everything.json", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(BadText, what_is_cut_off_at_any_byte_is_refused_where_it_ends) {
    const std::string text = everything();
    ASSERT_GT(text.size(), 5000U);
    ASSERT_EQ(format_document(parse_document(text).value()), text);
    // Behind the last bracket stands the end of the line.
    for (std::size_t size = 0; size + 1 < text.size(); ++size) {
        const auto document = parse_document(std::string_view(text).substr(0, size));
        ASSERT_FALSE(document.has_value()) << size;
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size), '\n');
        EXPECT_TRUE(document.error().where.starts_with("line " + std::to_string(line) + ", column ")) << size;
        EXPECT_NE(document.error().what.find("this is not JSON"), std::string::npos) << document.error().what;
    }
}

// Either it still is a document, which then comes back, or there is a sentence.
TEST(BadText, what_is_changed_is_another_document_or_refused) {
    const std::string text = everything();
    const std::string signs = "\"0-]}{[,:e. n\\";
    for (std::size_t at = 0; at < text.size(); at += 3) {
        std::string spoiled = text;
        spoiled[at] = at % 5 == 0 ? static_cast<char>(at % 251) : signs[at % signs.size()];
        const auto document = parse_document(spoiled);
        if (!document) {
            EXPECT_FALSE(document.error().what.empty());
            continue;
        }
        const std::string written = format_document(*document);
        const auto read = parse_document(written);
        ASSERT_TRUE(read.has_value()) << at << ": " << read.error().sentence();
        EXPECT_EQ(format_document(*read), written) << at;
    }
}

}  // namespace
}  // namespace batten::core
