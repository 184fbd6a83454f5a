// The classes of bugs that spline editors keep having, as far as commands can have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/session.h"
#include "app/editor/upkeep.h"
#include "random_session.h"
#include "sample_editor.h"

namespace batten::editor {
namespace {

// The text of a document apart from which curve is active, which is not undone.
std::string text_of(core::Document document) {
    document.active = 0;
    return core::format_document(document);
}

// The same curve values, not merely equal ones.
bool shares_curves(const core::Document& a, const core::Document& b) {
    return std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                      [](const core::DocumentCurve& x, const core::DocumentCurve& y) { return x.curve == y.curve; });
}

void expect_same(const core::Document& a, const core::Document& b) {
    EXPECT_TRUE(shares_curves(a, b));
    EXPECT_EQ(text_of(a), text_of(b));
}

// What must hold after every command.
void expect_sound(const EditorState& state, const Request& request) {
    const core::Document& document = state.history.present();
    EXPECT_TRUE(document.active < document.curves.size() || document.active == 0);
    EXPECT_TRUE(std::isfinite(state.view.parameter) && std::isfinite(state.parameter()));
    EXPECT_TRUE(is_in(state.hover, state.shown()));
    EXPECT_FALSE(request.phase == Phase::cancel && (state.preview || state.ghost));
    EXPECT_TRUE(!state.ghost || std::isfinite(state.ghost->deviation));
    const core::DocumentCurve* active = document.active_curve();
    if (active == nullptr) {
        EXPECT_EQ(state.selection, Selection{});
        return;
    }
    EXPECT_TRUE(active->curve->domain().contains(state.parameter()) || state.preview);
    const std::vector<std::size_t>& points = state.selection.points;
    EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
    EXPECT_TRUE(points.empty() || points.back() < active->curve->control_points().size());
    EXPECT_TRUE(!state.selection.knot || *state.selection.knot < active->curve->knots().stored().size());
}

// The documents that undo and redo should bring back, kept apart from the editor's own history.
class Expectation {
  public:
    explicit Expectation(const core::Document& start) : documents_{start} {}

    void follow(const Request& request, bool is_done, const EditorState& state) {
        const core::Document& present = state.history.present();
        if (request.phase == Phase::commit && is_done && request.command.name == "undo") --position_;
        if (request.phase == Phase::commit && is_done && request.command.name == "redo") ++position_;
        if (state.history.undo_count() > position_) {
            EXPECT_TRUE(is_done && request.phase == Phase::commit);
            documents_.resize(position_ + 1);
            documents_.push_back(present);
            ++position_;
        }
        ASSERT_EQ(state.history.undo_count(), position_);
        expect_same(present, documents_[position_]);
    }

    const core::Document& start() const { return documents_.front(); }
    const core::Document& end() const { return documents_.back(); }

  private:
    std::vector<core::Document> documents_;
    std::size_t position_ = 0;
};

class RandomSessions : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomSessions, pitfall_14_undo_and_redo_restore_the_identical_documents) {
    Editor editor;
    open_text(editor, sample_text);
    RandomSession session(GetParam());
    Expectation expectation(document(editor));
    int refused = 0;
    int done = 0;
    for (int i = 0; i < 400 && !::testing::Test::HasFailure(); ++i) {
        const Request request = session.next(editor.state());
        const bool had_preview = editor.state().preview.has_value();
        const bool is_done = editor.run(request);
        ++(is_done ? done : refused);
        SCOPED_TRACE("command " + std::to_string(i) + ", " + format_command(request.command) +
                     (is_done ? "" : " refused: " + editor.state().message.text));
        EXPECT_TRUE(is_done || editor.state().message.is_error);
        EXPECT_TRUE(request.phase == Phase::preview || had_preview || !editor.state().preview);
        expectation.follow(request, is_done, editor.state());
        expect_sound(editor.state(), request);
    }
    EXPECT_GT(done, 200);
    EXPECT_GT(refused, 20);
    while (editor.state().history.can_undo()) EXPECT_TRUE(editor.run({"undo", {}}));
    expect_same(document(editor), expectation.start());
    while (editor.state().history.can_redo()) EXPECT_TRUE(editor.run({"redo", {}}));
    expect_same(document(editor), expectation.end());
}

TEST_P(RandomSessions, pitfall_14_a_session_replayed_from_its_log_gives_the_same_document) {
    const TemporaryFolder folder;
    const std::string path = folder.write("sample.json", sample_text).string();
    Editor editor;
    editor.run({"open", {path}});
    RandomSession session(GetParam() + 1000);
    for (int i = 0; i < 400; ++i) editor.run(session.next(editor.state()));
    Editor replayed;
    for (const Command& command : editor.log()) {
        const Outcome<Command> read = parse_command(format_command(command));
        ASSERT_TRUE(read) << read.error();
        EXPECT_TRUE(replayed.run(*read)) << format_command(command) << ": " << replayed.state().message.text;
    }
    EXPECT_EQ(core::format_document(document(replayed)), core::format_document(document(editor)));
    EXPECT_EQ(replayed.state().history.undo_count(), editor.state().history.undo_count());
    EXPECT_EQ(replayed.state().selection, editor.state().selection);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSessions, ::testing::Range(1U, 13U));

TEST(Pitfalls, pitfall_14_a_drag_is_one_step_and_a_cancelled_one_is_none) {
    Editor editor;
    open_text(editor, sample_text);
    const std::string before = text_of(document(editor));
    for (double x = 0.0; x < 3.0; x += 0.125) editor.run(Request({"move-points", {2.0, x, -x}}, Phase::preview));
    editor.run(Request({}, Phase::cancel));
    EXPECT_EQ(text_of(document(editor)), before);
    EXPECT_FALSE(editor.state().history.can_undo());
    EXPECT_FALSE(editor.state().is_modified());
    for (double x = 0.0; x < 3.0; x += 0.125) editor.run(Request({"move-points", {2.0, x, -x}}, Phase::preview));
    editor.run({"move-points", {2.0, 3.0, -3.0}});
    EXPECT_EQ(editor.state().history.undo_count(), 1U);
    editor.run({"undo", {}});
    EXPECT_EQ(text_of(document(editor)), before);
}

// A vector typed by hand, with a double knot and uneven spans.
const std::vector<double> custom_knots{0, 0, 0, 0, 0.1, 0.4, 0.4, 1, 1, 1, 1};

class CustomVector : public ::testing::Test {
  protected:
    CustomVector() {
        open_text(editor_, sample_text);
        run("set-knots", {custom_knots});
    }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }

    // Whether `part` can be had from `whole` by leaving values out.
    static bool is_part(const std::vector<double>& part, const std::vector<double>& whole) {
        return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
    }

    Editor editor_;
};

TEST_F(CustomVector, pitfall_17_survives_edits_of_points_weights_and_entries) {
    for (const Command& command :
         {Command{"move-points", {std::vector<double>{1, 2}, 1.0, 1.0}}, Command{"set-point", {0.0, 9.0, 9.0}},
          Command{"set-weight", {3.0, 5.0}}, Command{"set-kind", {"custom"}}, Command{"rename-curve", {0.0, "other"}},
          Command{"set-curve-color", {0.0, "#000000"}}, Command{"undo", {}}, Command{"redo", {}},
          Command{"duplicate", {}}, Command{"copy", {}}, Command{"paste", {}}}) {
        EXPECT_TRUE(editor_.run(command)) << command.name << ": " << editor_.state().message.text;
        EXPECT_EQ(knots(editor_), custom_knots) << command.name;
        EXPECT_EQ(curve(editor_).knots().kind(), core::KnotKind::custom) << command.name;
    }
}

TEST_F(CustomVector, pitfall_17_gains_one_knot_with_an_added_point) {
    for (double index = 0.0; index <= 7.0; ++index) {
        ASSERT_TRUE(run("add-point", {index, 1.0, 1.0}));
        EXPECT_EQ(knots(editor_).size(), custom_knots.size() + 1) << index;
        EXPECT_TRUE(is_part(custom_knots, knots(editor_))) << index;
        run("undo");
    }
}

TEST_F(CustomVector, pitfall_17_loses_one_knot_with_a_deleted_point) {
    for (double index = 0.0; index <= 6.0; ++index) {
        ASSERT_TRUE(run("delete-points", {index})) << editor_.state().message.text;
        EXPECT_EQ(knots(editor_).size(), custom_knots.size() - 1) << index;
        EXPECT_TRUE(is_part(knots(editor_), custom_knots)) << index;
        run("undo");
    }
}

TEST_F(CustomVector, pitfall_17_keeps_its_values_in_another_degree) {
    EXPECT_TRUE(run("set-degree", {4.0}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0, 0.1, 0.1, 0.4, 0.4, 0.4, 1, 1, 1, 1, 1}));
    run("undo");
    EXPECT_TRUE(run("set-degree", {2.0}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0.1, 0.4, 1, 1, 1}));
}

TEST_F(CustomVector, pitfall_17_is_never_put_into_order_silently) {
    EXPECT_FALSE(run("set-knots", {std::vector<double>{0, 0, 0, 0, 0.4, 0.1, 0.4, 1, 1, 1, 1}}));
    EXPECT_EQ(editor_.state().message.text, "knot 5 is 0.1, less than knot 4, which is 0.4; knots must not decrease");
    EXPECT_FALSE(run("set-knot", {4.0, 0.7}));
    EXPECT_EQ(knots(editor_), custom_knots);
}

}  // namespace
}  // namespace batten::editor
