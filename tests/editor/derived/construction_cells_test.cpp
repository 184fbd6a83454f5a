#include "app/editor/derived/construction_cells.h"

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

using Places = std::vector<core::CellPlace>;

EditorState state_at(const core::CurveDefinition& definition, double u) {
    EditorState state = test::state_with(definition);
    state.view.parameter = u;
    return state;
}

core::DeBoorTriangle triangle_of(const EditorState& state) {
    return core::de_boor_triangle(*state.active_curve(), state.parameter());
}

Places lit_cells(const EditorState& state) {
    const core::DeBoorTriangle triangle = triangle_of(state);
    Places lit;
    for (std::size_t r = 0; r < triangle.levels.size(); ++r)
        for (std::size_t j = 0; j < triangle.levels[r].size(); ++j)
            if (is_lit_cell(state, triangle, {r, j})) lit.push_back({r, j});
    return lit;
}

TEST(ConstructionCells, light_up_with_what_is_hovered_on_the_canvas) {
    EditorState state = state_at(test::cubic(), 0.4);  // the points 1 to 4
    EXPECT_EQ(lit_cells(state), Places{});
    state.hover = HoveredCell{1, 2};
    EXPECT_EQ(lit_cells(state), (Places{{1, 2}}));
    state.hover = HoveredPoint{3};
    EXPECT_EQ(lit_cells(state), (Places{{0, 2}}));
    state.hover = HoveredPoint{6};
    EXPECT_EQ(lit_cells(state), Places{});
    state.hover = HoveredParameter{};
    EXPECT_EQ(lit_cells(state), (Places{{3, 0}}));
}

TEST(ConstructionCells, of_a_closed_curve_light_up_by_the_point_that_comes_round) {
    EditorState state = state_at(test::closed_cubic(), 5.5);  // the points 5, 0, 1, 2
    state.hover = HoveredPoint{0};
    EXPECT_EQ(lit_cells(state), (Places{{0, 1}}));
    core::CurveDefinition small{.degree = 3, .knots = {0, 1, 2}, .points = {{-1, 0}, {1, 0}}, .periodic = true};
    state = state_at(small, 0.5);
    state.hover = HoveredPoint{0};
    EXPECT_EQ(lit_cells(state).size(), 2U);
}

TEST(ConstructionCells, are_hovered_only_where_the_triangle_has_them) {
    EditorState state = state_at(test::cubic(), 0.4);
    state.hover = HoveredCell{3, 0};
    EXPECT_EQ(hovered_cell(state, triangle_of(state)), (core::CellPlace{3, 0}));
    for (const HoveredCell missing : {HoveredCell{3, 1}, HoveredCell{4, 0}}) {
        state.hover = missing;
        EXPECT_EQ(hovered_cell(state, triangle_of(state)), std::nullopt);
    }
}

TEST(ConstructionCells, have_marks_up_to_the_level_of_the_view_but_not_for_the_curve_point) {
    EditorState state = state_at(test::cubic(), 0.4);
    EXPECT_EQ(marked_cells(state.view, triangle_of(state)), (Places{{1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}}));
    state.view.level = 1;
    EXPECT_EQ(marked_cells(state.view, triangle_of(state)), (Places{{1, 0}, {1, 1}, {1, 2}}));
    state.view.level = 0;
    EXPECT_EQ(marked_cells(state.view, triangle_of(state)), Places{});
    state = state_at(test::cubic(), 0.25);  // a knot, where the last of each level are those above them
    EXPECT_EQ(marked_cells(state.view, triangle_of(state)), (Places{{1, 0}, {1, 1}, {2, 0}}));
    state = state_at(test::cubic(), 0.0);
    EXPECT_EQ(marked_cells(state.view, triangle_of(state)), Places{});
    core::CurveDefinition line{.degree = 1, .knots = {0, 0, 1, 1}, .points = {{0, 0}, {1, 1}}};
    state = state_at(line, 0.5);
    EXPECT_EQ(marked_cells(state.view, triangle_of(state)), Places{});
}

}  // namespace
}  // namespace batten::editor
