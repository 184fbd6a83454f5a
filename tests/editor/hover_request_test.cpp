#include "app/editor/hover_request.h"

#include <gtest/gtest.h>

#include "app/editor/commands/hover_names.h"

namespace batten::editor {
namespace {

TEST(HoverRequest, names_every_hovered_thing_as_the_hover_command_reads_it) {
    const Hover all[] = {HoveredNothing{}, HoveredPoint{3},      HoveredWeightRing{2}, HoveredKnot{5},
                         HoveredSpan{4},   HoveredCell{2, 1},    HoveredParameter{},   HoveredCurve{0.375},
                         HoveredLeg{1},    HoveredOtherCurve{2}, HoveredBasis{6}};
    for (const Hover& hover : all) {
        const Command command = hover_command(hover);
        EXPECT_EQ(command.name, "hover");
        const Outcome<Hover> read = hover_named(std::get<std::string>(command.arguments.at(0)),
                                                std::get<std::vector<double>>(command.arguments.at(1)));
        ASSERT_TRUE(read) << hover.index();
        EXPECT_EQ(*read, hover);
    }
}

TEST(HoverRequest, asks_for_nothing_that_is_hovered_already) {
    EditorState state;
    state.hover = HoveredPoint{3};
    CommandQueue queue;
    request_hover(HoveredPoint{3}, state, queue);
    EXPECT_TRUE(queue.is_empty());
    request_hover(HoveredPoint{2}, state, queue);
    const std::vector<Request> requests = queue.take();
    ASSERT_EQ(requests.size(), 1U);
    EXPECT_EQ(requests[0].command, (Command{"hover", {"point", std::vector<double>{2.0}}}));
    EXPECT_EQ(requests[0].phase, Phase::commit);
}

}  // namespace
}  // namespace batten::editor
