#include "app/editor/pointer/hover_request.h"

#include <gtest/gtest.h>

namespace batten::editor {
namespace {

TEST(HoverRequest, asks_for_nothing_that_is_hovered_already) {
    EditorState state;
    state.hover = HoveredPoint{3};
    CommandQueue queue;
    request_hover(HoveredPoint{3}, state, queue);
    EXPECT_TRUE(queue.is_empty());
    request_hover(HoveredPoint{2}, state, queue);
    const std::vector<Request> requests = queue.take();
    ASSERT_EQ(requests.size(), 1U);
    EXPECT_EQ(std::get<SetHover>(std::get<ViewChange>(requests[0])).hover, Hover(HoveredPoint{2}));
}

}  // namespace
}  // namespace batten::editor
