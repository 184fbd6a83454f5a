#include "app/editor/history.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace batten::editor
