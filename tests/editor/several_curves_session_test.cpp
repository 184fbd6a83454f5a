// Whole sessions over several curves, some of them grouped, hidden, locked, linked or made of points: what is locked
// keeps every bit, what is hidden is not changed by hand, and undo goes back to the first bit.

#include <gtest/gtest.h>

#include "app/editor/command_reader.h"
#include "app/editor/commands/drawing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fit_point_commands.h"
#include "app/editor/commands/group_commands.h"
#include "app/editor/commands/joint_mark_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/selected_curve_commands.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/session.h"
#include "app/editor/state/same_document.h"
#include "core/make/fit_points.h"
#include "tests/editor/random_hand.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

core::Document first_document() {
    Editor editor;
    const std::vector<Command> commands{
        NewCurve{.points = {{-5, 0}, {-4, 2}, {-2, 1}, {0, -1}, {1, 2}, {3, 0}, {4, 1}}},
        MarkJoint{.mark = core::JointMark::curvature, .u = 0.5},
        PinPoints{.points = {0, 5}},
        NewCurve{.points = {{1, 2}, {2, 2}, {3, 1}, {2, -1}, {1, -3}}},
        LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false},
        ThroughPoints{.points = {{-6, 3}, {-4, 2.5}, {-2, 3.5}, {0, 3}}},
        AddArc{.center = {3.0, -2.0}, .radius = 1.0, .start = 0.0, .sweep = 270.0},
        AddLine{.from = {-6, -3}, .to = {6, -3.5}},
        NewCurve{.points = {{-3, -1}, {-1, 1}, {1, -1}, {3, 1}, {5, -1}}},
        GroupCurves{.name = "pair", .curves = {0, 4}},
        HideCurves{.curves = {4}},
        LockCurves{.curves = {5}},
    };
    for (const Command& command : commands) EXPECT_TRUE(editor.run(command)) << editor.state().message.text;
    return document(editor);
}

bool has_same_shape(const core::DocumentCurve& a, const core::DocumentCurve& b) {
    const bool has_same_points = a.fit == nullptr ? b.fit == nullptr : b.fit != nullptr && *a.fit == *b.fit;
    return *a.curve == *b.curve && has_same_points && a.pinned == b.pinned && a.joints == b.joints;
}

// Those of `before` for which `is_meant` holds and that `after` does not have any more with the same shape.
template <class IsMeant>
std::vector<std::string> changed_curves(const core::Document& before, const core::Document& after, IsMeant is_meant) {
    std::vector<std::string> changed;
    for (const core::DocumentCurve& entry : before.curves)
        if (is_meant(entry) && std::ranges::none_of(after.curves, [&](const core::DocumentCurve& now) {
                return has_same_shape(entry, now);
            }))
            changed.push_back(entry.name);
    return changed;
}

class SeveralCurvesSessions : public ::testing::TestWithParam<unsigned> {
  protected:
    SeveralCurvesSessions() { open_text(editor_, core::format_document(first_document())); }

    std::string last_logged() const { return editor_.log().empty() ? "nothing" : format_command(editor_.log().back()); }

    // What else was asked for than to take back steps.
    bool is_undo() const {
        const Command& last = editor_.log().back();
        return last.as<Undo>() != nullptr || last.as<Redo>() != nullptr;
    }

    void edit_by_hand() {
        const core::Document before = document(editor_);
        hand_.gesture();
        SCOPED_TRACE(last_logged());
        const auto is_kept = [](const core::DocumentCurve& entry) { return !entry.visible && !entry.symmetry; };
        EXPECT_EQ(changed_curves(before, document(editor_), is_kept), std::vector<std::string>{});
    }

    void run_if_possible(const CommandSpec& spec) {
        if (const auto command = read_command(spec, editor_.state())) editor_.run(*command);
    }

    // Now and then all is shown and unlocked, or something hidden and locked, lest a session comes to a rest.
    void edit() {
        const std::size_t count = document(editor_).curves.size();
        switch (generator_() % 24) {
            case 0:
                run_if_possible(ShowCurves::spec());
                break;
            case 1:
                run_if_possible(UnlockCurves::spec());
                break;
            case 2:
                if (count > 0) editor_.run(HideCurves{.curves = {generator_() % count}});
                break;
            case 3:
                if (count > 0) editor_.run(LockCurves{.curves = {generator_() % count}});
                break;
            default:
                if (generator_() % 2 == 0)
                    edit_by_hand();
                else
                    editor_.perform(commands_.next(editor_.state()));
        }
    }

    Editor editor_;
    std::mt19937 generator_{GetParam()};
    RandomSession commands_{GetParam() + 500};
    test::RandomHand hand_{editor_, GetParam() + 500};
};

TEST_P(SeveralCurvesSessions, keep_what_is_locked_and_hidden_and_undo_to_the_first_document) {
    const core::Document first = document(editor_);
    for (std::size_t i = 0; editor_.state().history.undo_count() < 200 && !HasFailure(); ++i) {
        ASSERT_LT(i, 5'000U);
        const core::Document before = document(editor_);
        edit();
        SCOPED_TRACE(std::to_string(i) + ": " + last_logged());
        const core::Document& after = document(editor_);
        if (has_same_content(before, after)) continue;
        const auto is_locked = [](const core::DocumentCurve& entry) { return entry.locked; };
        EXPECT_TRUE(is_undo() || changed_curves(before, after, is_locked).empty());
        const auto read = core::parse_document(core::format_document(after));
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_TRUE(is_same_document(*read, after));
    }
    const std::string last = core::format_document(document(editor_));
    while (editor_.state().history.can_undo()) EXPECT_TRUE(editor_.run(Undo{}));
    EXPECT_TRUE(has_same_content(document(editor_), first));
    while (editor_.state().history.can_redo()) EXPECT_TRUE(editor_.run(Redo{}));
    EXPECT_TRUE(is_same_document(*core::parse_document(last), document(editor_)));
}

INSTANTIATE_TEST_SUITE_P(Seeds, SeveralCurvesSessions, ::testing::Range(1U, 5U));

}  // namespace
}  // namespace batten::editor
