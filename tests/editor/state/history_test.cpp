#include "app/editor/state/history.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/edit/point_edit.h"

namespace batten::editor {
namespace {

core::Document titled(const std::string& title) {
    core::Document document;
    document.title = title;
    return document;
}

TEST(History, begins_with_nothing_to_undo) {
    const History history(titled("start"));
    EXPECT_FALSE(history.can_undo());
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo_label(), "");
    EXPECT_EQ(history.redo_label(), "");
    EXPECT_TRUE(history.is_saved());
    EXPECT_EQ(history.present().title, "start");
}

TEST(History, goes_back_and_forth_with_the_labels_of_the_steps) {
    History history(titled("start"));
    history.push("first", titled("one"));
    history.push("second", titled("two"));
    EXPECT_EQ(history.undo_label(), "second");
    history.undo();
    EXPECT_EQ(history.present().title, "one");
    EXPECT_EQ(history.undo_label(), "first");
    EXPECT_EQ(history.redo_label(), "second");
    history.undo();
    history.undo();
    EXPECT_EQ(history.present().title, "start");
    history.redo();
    history.redo();
    history.redo();
    EXPECT_EQ(history.present().title, "two");
    EXPECT_EQ(history.undo_count(), 2U);
    EXPECT_EQ(history.redo_count(), 0U);
}

TEST(History, forgets_what_was_undone_when_something_new_is_done) {
    History history;
    history.push("first", titled("one"));
    history.push("second", titled("two"));
    history.undo();
    history.push("third", titled("three"));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo_count(), 2U);
    history.undo();
    EXPECT_EQ(history.present().title, "one");
}

TEST(History, knows_the_saved_document_again) {
    History history;
    history.push("first", titled("one"));
    EXPECT_FALSE(history.is_saved());
    history.mark_saved();
    history.push("second", titled("two"));
    EXPECT_FALSE(history.is_saved());
    history.undo();
    EXPECT_TRUE(history.is_saved());
    history.undo();
    EXPECT_FALSE(history.is_saved());
}

TEST(History, knows_an_equal_document_whatever_led_to_it) {
    History history(titled("one"));
    history.push("there", titled("two"));
    EXPECT_FALSE(history.is_saved());
    history.push("and back", titled("one"));
    EXPECT_TRUE(history.is_saved());
    history.undo();
    EXPECT_FALSE(history.is_saved());
}

TEST(History, never_takes_another_document_for_the_saved_one) {
    History history;
    history.push("first", titled("one"));
    history.mark_saved();
    history.undo();
    history.push("other", titled("other"));
    EXPECT_FALSE(history.is_saved());
    history.undo();
    EXPECT_FALSE(history.is_saved());
}

// A cubic with 1000 control points holds 1004 knots, and as many points and weights as that.
constexpr std::size_t point_bytes = 1000 * 2 * sizeof(double);
constexpr std::size_t curve_bytes = 1004 * sizeof(double) + point_bytes + 1000 * sizeof(double);
constexpr std::size_t entry_bytes = sizeof(core::DocumentCurve) + 4;  // with its name

core::Document long_curve() {
    core::CurveDefinition definition{.degree = 3, .points = std::vector<core::Point>(1000)};
    for (int i = 0; i < 1004; ++i) definition.knots.push_back(i);
    core::DocumentCurve item;
    item.name = "long";
    item.curve = std::make_shared<const core::Curve>(core::Curve::make(definition).value());
    core::Document document;
    document.curves.push_back(item);
    return document;
}

core::Document with_point(core::Document document, double x) {
    std::shared_ptr<const core::Curve>& curve = document.curves.front().curve;
    curve = std::make_shared<const core::Curve>(core::set_control_point(*curve, 500, {x, 0.0}).value());
    return document;
}

TEST(History, counts_what_documents_do_not_share) {
    History history(long_curve());
    EXPECT_EQ(history.byte_count(), curve_bytes + entry_bytes);
    history.push("renamed", history.present());
    EXPECT_EQ(history.byte_count(), curve_bytes + 2 * entry_bytes);
    history.push("moved", with_point(history.present(), 1.0));
    EXPECT_EQ(history.byte_count(), curve_bytes + point_bytes + 3 * entry_bytes);
    core::Document twice = history.present();
    twice.curves.push_back(twice.curves.front());
    history.push("copied", twice);
    EXPECT_EQ(history.byte_count(), curve_bytes + point_bytes + 5 * entry_bytes);
    history.undo();
    history.undo();
    EXPECT_EQ(history.byte_count(), curve_bytes + point_bytes + 5 * entry_bytes);
    history.push("moved elsewhere", with_point(history.present(), 2.0));
    EXPECT_EQ(history.byte_count(), curve_bytes + point_bytes + 3 * entry_bytes);
}

TEST(History, forgets_the_oldest_steps_where_they_hold_more_than_is_kept) {
    const std::size_t step_bytes = point_bytes + entry_bytes;
    const std::size_t most_bytes = curve_bytes + entry_bytes + 3 * step_bytes;
    History history(long_curve(), most_bytes);
    for (int i = 1; i <= 50; ++i) {
        history.push("move", with_point(history.present(), i));
        EXPECT_EQ(history.undo_count(), static_cast<std::size_t>(std::min(i, 3)));
        EXPECT_LE(history.byte_count(), most_bytes);
    }
    for (int i = 0; i < 3; ++i) history.undo();
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.present().curves.front().curve->control_points()[500].x, 47.0);
    EXPECT_EQ(history.redo_count(), 3U);
    EXPECT_FALSE(history.is_saved());
}

TEST(History, never_forgets_the_last_step) {
    History history(long_curve(), 1);
    for (int i = 1; i <= 3; ++i) history.push("move", with_point(history.present(), i));
    EXPECT_EQ(history.undo_count(), 1U);
    history.undo();
    EXPECT_EQ(history.present().curves.front().curve->control_points()[500].x, 2.0);
}

TEST(History, counts_what_is_changed_without_a_step) {
    History history(long_curve());
    history.push("moved", with_point(history.present(), 1.0));
    history.undo();
    history.amend(with_point(history.present(), 2.0));
    EXPECT_EQ(history.byte_count(), curve_bytes + point_bytes + 2 * entry_bytes);
    EXPECT_FALSE(history.is_saved());
    history.mark_saved();
    EXPECT_TRUE(history.is_saved());
    history.redo();
    EXPECT_FALSE(history.is_saved());
}

}  // namespace
}  // namespace batten::editor
