#include "app/editor/derived/continuity_meter.h"

#include <gtest/gtest.h>

#include "app/editor/cards/continuity_card.h"
#include "app/editor/editor.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

// Two cubics that meet in (3, 1) with the speeds 6 and 12.
core::CurveDefinition two_cubics() {
    core::CurveDefinition definition;
    definition.knots = {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1};
    definition.points = {{0, 0}, {1, 2}, {2, 1}, {3, 1}, {5, 1}, {6, 3}, {7, 0}};
    return definition;
}

core::CurveDefinition long_curve(std::size_t count) {
    core::CurveDefinition definition;
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 3, count).value();
    definition.knots = {knots.values().begin(), knots.values().end()};
    definition.points = test::scattered_points(count, {8.0, 4.0});
    return definition;
}

std::vector<double> values_of(const ContinuityMeter& meter) {
    std::vector<double> values;
    for (const KnotJoint& row : meter.rows) values.push_back(row.joint.u);
    return values;
}

TEST(ContinuityMeter, has_the_knots_inside_the_domain) {
    const ContinuityMeter meter = continuity_meter(test::sample_state(), 12);
    EXPECT_EQ(meter.count, 3U);
    EXPECT_EQ(values_of(meter), (std::vector{0.25, 0.5, 0.75}));
    // The parameter is 0.4.
    EXPECT_EQ(meter.focus->joint.u, 0.5);
    EXPECT_FALSE(meter.ends);
    EXPECT_TRUE(meter.meetings.empty());
}

TEST(ContinuityMeter, points_at_the_knot_that_is_hovered_or_else_selected) {
    EditorState state = test::scene_state(long_curve(8));  // knots at 1/5, 2/5, ...
    state.view.parameter = 0.9;
    EXPECT_EQ(continuity_meter(state, 12).focus->joint.u, 0.8);
    state.selection.knot = 5;
    EXPECT_EQ(continuity_meter(state, 12).focus->joint.u, 0.4);
    EXPECT_EQ(continuity_meter(state, 12).focus->knot, 5U);
    state.hover = HoveredKnot{4};
    EXPECT_EQ(continuity_meter(state, 12).focus->joint.u, 0.2);
    // The end of the domain is no joint.
    state.hover = HoveredKnot{0};
    EXPECT_EQ(continuity_meter(state, 12).focus->joint.u, 0.4);
}

TEST(ContinuityMeter, of_many_knots_has_those_around_the_chosen_one_wherever_the_pointer_is) {
    EditorState state = test::scene_state(long_curve(10003));  // knots at k/10000
    state.view.parameter = 0.5;
    const ContinuityMeter meter = continuity_meter(state, 12);
    EXPECT_EQ(meter.count, 9999U);
    EXPECT_EQ(meter.rows.size(), 12U);
    EXPECT_EQ(meter.first, 4993U);
    EXPECT_EQ(meter.focus->joint.u, 0.5);
    state.hover = HoveredKnot{meter.rows[2].knot};
    EXPECT_EQ(continuity_meter(state, 12).first, meter.first);
    EXPECT_EQ(continuity_meter(state, 12).focus->knot, meter.rows[2].knot);
    state.view.parameter = 1.0;
    EXPECT_EQ(continuity_meter(state, 12).first, 9987U);
    state.view.parameter = 0.0;
    EXPECT_EQ(continuity_meter(state, 12).first, 0U);
}

TEST(ContinuityMeter, has_the_seam_of_a_periodic_curve_and_no_ends) {
    core::CurveDefinition ring;
    ring.degree = 2;
    ring.knots = {0, 1, 2, 3, 3};
    ring.points = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    ring.periodic = true;
    EditorState state = test::scene_state(ring);
    const ContinuityMeter meter = continuity_meter(state, 12);
    EXPECT_EQ(values_of(meter), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(meter.rows[0].joint.kind, core::JointKind::seam);
    EXPECT_EQ(meter.rows[0].joint.multiplicity, 2);
    EXPECT_FALSE(meter.ends);
    state.hover = HoveredKnot{4};  // the end of the period is its beginning
    EXPECT_EQ(continuity_meter(state, 12).focus->joint.u, 0.0);
}

TEST(ContinuityMeter, leaves_out_knots_beyond_the_domain) {
    core::CurveDefinition uniform;
    uniform.degree = 2;
    uniform.knots = {0, 1, 2, 3, 4, 5, 6, 7};
    uniform.points = {{0, 0}, {1, 2}, {4, 5}, {7, 2}, {8, 0}};
    EditorState state = test::scene_state(uniform);
    EXPECT_EQ(values_of(continuity_meter(state, 12)), (std::vector<double>{3, 4}));
    state.hover = HoveredKnot{1};
    EXPECT_EQ(continuity_meter(state, 12).focus->joint.u, 3.0);
}

TEST(ContinuityMeter, of_one_piece_has_no_rows_but_its_ends_where_they_meet) {
    core::CurveDefinition drop;
    drop.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    drop.points = {{0, 0}, {2, 2}, {-2, 2}, {0, 0}};
    const ContinuityMeter meter = continuity_meter(test::scene_state(drop), 12);
    EXPECT_EQ(meter.count, 0U);
    EXPECT_FALSE(meter.focus);
    EXPECT_EQ(meter.ends->geometric, 0);
}

// The state with another visible curve beside the active one.
EditorState with_other(const core::CurveDefinition& active, const core::CurveDefinition& other, bool visible = true) {
    EditorState state = test::scene_state(active);
    core::Document document = state.history.present();
    core::DocumentCurve entry = document.curves.front();
    entry.name = "other";
    entry.curve = std::make_shared<const core::Curve>(core::Curve::make(other).value());
    entry.visible = visible;
    document.curves.push_back(entry);
    state.preview = document;
    return state;
}

core::CurveDefinition cubic_from(core::Point start, core::Point next) {
    core::CurveDefinition cubic;
    cubic.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    cubic.points = {start, next, {9, 3}, {9, 1}};
    return cubic;
}

TEST(ContinuityMeter, finds_other_curves_at_its_ends) {
    // C' is 3 * 2 * (1, -3) at the end of the one and 3 * (1, -3) at the start of the other.
    const EditorState state = with_other(two_cubics(), cubic_from({7, 0}, {8, -3}));
    const ContinuityMeter meter = continuity_meter(state, 12);
    ASSERT_EQ(meter.meetings.size(), 1U);
    EXPECT_EQ(meter.meetings[0].other, 1U);
    EXPECT_EQ(meter.meetings[0].ends, (core::JoinedEnds{core::CurveEnd::end, core::CurveEnd::start}));
    EXPECT_EQ(meter.meetings[0].joint.geometric, 1);
    EXPECT_EQ(core::speed_ratio(meter.meetings[0].joint), 0.5);
    EXPECT_TRUE(continuity_meter(with_other(two_cubics(), cubic_from({7, 0.9}, {8, -3})), 12).meetings.empty());
    EXPECT_TRUE(continuity_meter(with_other(two_cubics(), cubic_from({7, 0}, {8, -3}), false), 12).meetings.empty());
}

TEST(ContinuityMeter, tells_the_gap_of_ends_that_are_about_to_meet) {
    const EditorState state = with_other(two_cubics(), cubic_from({7, 0.25}, {8, -3}));
    const ContinuityMeter meter = continuity_meter(state, 12);
    ASSERT_EQ(meter.meetings.size(), 1U);
    EXPECT_EQ(meter.meetings[0].ends, (core::JoinedEnds{core::CurveEnd::end, core::CurveEnd::start}));
    EXPECT_EQ(meter.meetings[0].joint.geometric, -1);
    const std::string text = card_text(continuity_card(state));
    EXPECT_NE(text.find("End to start of 'other': the curves do not meet\n1/4 | "), std::string::npos) << text;
    EXPECT_NE(text.find("With 'other': a gap of 1/4"), std::string::npos) << text;
}

TEST(ContinuityCard, has_a_row_for_each_knot_and_the_values_at_one) {
    EXPECT_EQ(card_text(continuity_card(test::scene_state(two_cubics()))),
              "Continuity\n"
              "At u = 1/2: the same direction; 2 times as fast beyond it\n"
              " | u− | u+\n"
              "C′ | (6, 0) | (12, 0)\n"
              "C″ | (0, 24) | (−24, 48)\n"
              "κ | 2/3 | 1/3\n"
              "[C′] is how far C′ jumps; up to a millionth of C′ counts as none.\n"
              "[C] | [C′] | [C″] | turn | [κ]\n"
              "u = 1/2 ×3: C⁰ by its knots, G¹ by its shape\n"
              "0 | 6 | 33.94 | 0° | 1/3");
}

TEST(ContinuityCard, follows_a_knot_onto_another_down_to_the_tear) {
    core::CurveDefinition definition;
    definition.points = {{0, 0}, {1, 3}, {2, -1}, {4, 2}, {5, 5}, {7, 1}, {8, 0}, {9, 4}};
    definition.tears = core::Tears::allow;
    const std::vector<std::vector<double>> inner{
        {0.5, 0.6, 0.7, 0.8}, {0.5, 0.5, 0.7, 0.8}, {0.5, 0.5, 0.5, 0.8}, {0.5, 0.5, 0.5, 0.5}};
    const std::vector<std::string> verdicts{"u = 1/2: C² by its knots", "u = 1/2 ×2: C¹ by its knots",
                                            "u = 1/2 ×3: C⁰ by its knots, a corner by its shape",
                                            "u = 1/2 ×4: torn by its knots, a gap by its shape"};
    for (std::size_t k = 0; k < inner.size(); ++k) {
        definition.knots = {0, 0, 0, 0};
        definition.knots.insert(definition.knots.end(), inner[k].begin(), inner[k].end());
        definition.knots.insert(definition.knots.end(), 4, 1.0);
        const std::string text = card_text(continuity_card(test::scene_state(definition)));
        EXPECT_NE(text.find(verdicts[k] + "\n"), std::string::npos) << text;
    }
}

TEST(ContinuityCard, says_which_knots_of_many_are_shown) {
    EditorState state = test::scene_state(long_curve(10003));
    state.view.parameter = 0.5;
    const Card card = continuity_card(state);
    EXPECT_NE(card_text(card).find("u = 0.5001: C² by its knots"), std::string::npos);
    EXPECT_NE(card_text(card).find("Knots 4995 to 5004 of 9999, around u."), std::string::npos);
}

TEST(ContinuityCard, names_the_curves_that_are_met) {
    const EditorState state = with_other(two_cubics(), cubic_from({7, 0}, {8, -3}));
    const std::string text = card_text(continuity_card(state));
    // 6 (1, -3) and 3 (1, -3)
    EXPECT_NE(text.find("End to start of 'other': the curves meet with G¹\n0 | 9.487 | "), std::string::npos) << text;
    EXPECT_NE(text.find("With 'other': the same direction; 1/2 times as fast beyond it"), std::string::npos) << text;
}

TEST(ContinuityCard, of_nothing_to_measure_says_so) {
    core::CurveDefinition piece;
    piece.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    piece.points = {{0, 0}, {2, 2}, {4, 2}, {5, 0}};
    EXPECT_NE(card_text(continuity_card(test::scene_state(piece))).find("the curve is one piece"), std::string::npos);
    EXPECT_NE(card_text(continuity_card(Editor().state())).find("There is no curve"), std::string::npos);
}

TEST(ContinuityCard, lights_the_knot_of_its_row) {
    const Card card = continuity_card(test::scene_state(two_cubics()));
    const auto& table = std::get<CardTable>(card.blocks[3]);
    EXPECT_EQ(table.rows[1].front().hover, Hover(HoveredKnot{6})) << "the topmost of its stack";
    EXPECT_TRUE(table.rows[1].front().command.has_value());
}

}  // namespace
}  // namespace batten::editor
