#include "app/editor/example_files.h"

#include <gtest/gtest.h>

#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const std::filesystem::path& file : example_files(folder)) names.push_back(file.stem().string());
    return names;
}

TEST(ExampleFiles, come_in_the_given_order_and_the_others_by_name) {
    const TemporaryFolder folder;
    for (const char* name : {"b.json", "a.json", "d.json", "c.json", "notes.md"}) folder.write(name, "{}");
    EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a", "b", "c", "d"}));
    folder.write("order.txt", "d\nmissing\nb\n");
    EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"d", "b", "a", "c"}));
    EXPECT_EQ(names_in(folder.path() / "nowhere"), std::vector<std::string>{});
}

// Each step of a lecture stands on those before: pieces, uniform knots, the construction, unequal knots, multiple ones,
// insertion, weights.
TEST(ExampleFiles, of_the_program_are_in_the_order_of_a_lecture) {
    EXPECT_EQ(names_in(BATTEN_EXAMPLES),
              (std::vector<std::string>{"bezier-cubic", "coons-open", "coons-closed", "coons-joined", "cubic-de-boor",
                                        "cubic-at-4-5", "knots-t1", "knots-t2", "quadratic-double-knot", "knots-t3",
                                        "knots-t4", "knot-insertion", "conic-weight", "circle-nurbs", "wave"}));
}

}  // namespace
}  // namespace batten::editor
