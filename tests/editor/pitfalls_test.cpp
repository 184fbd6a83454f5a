// The classes of bugs that spline editors keep having, as far as commands can have them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/command_spec.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/session.h"
#include "app/editor/state/selected_parts.h"
#include "app/editor/upkeep.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

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

// What must hold after every request.
void expect_sound(const EditorState& state, const Request& request) {
    const core::Document& document = state.history.present();
    EXPECT_TRUE(document.active < document.curves.size() || document.active == 0);
    EXPECT_TRUE(std::isfinite(state.view.parameter) && std::isfinite(state.parameter()));
    EXPECT_TRUE(is_in(state.hover, state.shown()));
    EXPECT_FALSE(std::holds_alternative<CancelPreview>(request) && (state.preview || state.ghost));
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
    std::size_t last = 0;
    for (const SelectedPart& part : selected_parts(state)) {
        ASSERT_LT(part.curve, document.curves.size());
        EXPECT_TRUE(last == 0 || last - 1 < part.curve);
        last = part.curve + 1;
        const core::DocumentCurve& entry = document.curves[part.curve];
        EXPECT_TRUE(part.is_whole() || part.points.back() < entry.curve->control_points().size());
        EXPECT_TRUE(can_be_selected(entry) || part.curve == document.active);
    }
    EXPECT_TRUE(!state.selection.knot || *state.selection.knot < active->curve->knots().stored().size());
}

// The command that `request` commits, or null.
const Command* committed_by(const Request& request) {
    const auto* command = std::get_if<CommandRequest>(&request);
    return command != nullptr && command->phase == Phase::commit ? &command->command : nullptr;
}

bool is_preview(const Request& request) {
    const auto* command = std::get_if<CommandRequest>(&request);
    return command != nullptr && command->phase == Phase::preview;
}

// The request as a line, for messages.
std::string text_of(const Request& request) {
    const auto* command = std::get_if<CommandRequest>(&request);
    return command != nullptr ? format_command(command->command) : "not a command";
}

// Whether all went well; what is not a command always does.
bool perform(Editor& editor, const Request& request) {
    if (const auto* command = std::get_if<CommandRequest>(&request))
        return editor.run(command->command, command->phase);
    editor.perform(request);
    return true;
}

// The documents that undo and redo should bring back, kept apart from the editor's own history.
class Expectation {
  public:
    explicit Expectation(const core::Document& start) : documents_{start} {}

    void follow(const Request& request, bool is_done, const EditorState& state) {
        const core::Document& present = state.history.present();
        const Command* committed = committed_by(request);
        if (is_done && committed != nullptr && committed->as<Undo>() != nullptr) --position_;
        if (is_done && committed != nullptr && committed->as<Redo>() != nullptr) ++position_;
        if (state.history.undo_count() > position_) {
            EXPECT_TRUE(is_done && committed != nullptr);
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
        const bool is_done = perform(editor, request);
        ++(is_done ? done : refused);
        SCOPED_TRACE("request " + std::to_string(i) + ", " + text_of(request) +
                     (is_done ? "" : " refused: " + editor.state().message.text));
        EXPECT_TRUE(is_done || !editor.state().message.text.empty());
        EXPECT_TRUE(is_preview(request) || had_preview || !editor.state().preview);
        expectation.follow(request, is_done, editor.state());
        expect_sound(editor.state(), request);
    }
    EXPECT_GT(done, 200);
    EXPECT_GT(refused, 20);
    while (editor.state().history.can_undo()) EXPECT_TRUE(editor.run(Undo{}));
    expect_same(document(editor), expectation.start());
    while (editor.state().history.can_redo()) EXPECT_TRUE(editor.run(Redo{}));
    expect_same(document(editor), expectation.end());
}

TEST_P(RandomSessions, pitfall_14_a_session_replayed_from_its_log_gives_the_same_document) {
    const TemporaryFolder folder;
    const std::string path = folder.write("sample.json", sample_text).string();
    Editor editor;
    editor.run(Open{.path = path});
    RandomSession session(GetParam() + 1000);
    for (int i = 0; i < 400; ++i) editor.perform(session.next(editor.state()));
    Editor replayed;
    for (const Command& command : editor.log()) {
        const Outcome<Command> read = parse_command(format_command(command), replayed.state());
        ASSERT_TRUE(read) << read.error();
        EXPECT_TRUE(replayed.run(*read)) << format_command(command) << ": " << replayed.state().message.text;
    }
    EXPECT_EQ(core::format_document(document(replayed)), core::format_document(document(editor)));
    EXPECT_EQ(replayed.state().history.undo_count(), editor.state().history.undo_count());
    EXPECT_EQ(replayed.state().selection, editor.state().selection);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSessions, ::testing::Range(1U, 13U));

TEST(Pitfalls, pitfall_14_a_drag_is_one_step_and_a_canceled_one_is_none) {
    Editor editor;
    open_text(editor, sample_text);
    const std::string before = text_of(document(editor));
    for (double x = 0.0; x < 3.0; x += 0.125) editor.run(MovePoints{.points = {2}, .offset = {x, -x}}, Phase::preview);
    editor.cancel_preview();
    EXPECT_EQ(text_of(document(editor)), before);
    EXPECT_FALSE(editor.state().history.can_undo());
    EXPECT_FALSE(editor.state().is_modified());
    for (double x = 0.0; x < 3.0; x += 0.125) editor.run(MovePoints{.points = {2}, .offset = {x, -x}}, Phase::preview);
    editor.run(MovePoints{.points = {2}, .offset = {3.0, -3.0}});
    EXPECT_EQ(editor.state().history.undo_count(), 1U);
    editor.run(Undo{});
    EXPECT_EQ(text_of(document(editor)), before);
}

// A vector typed by hand, with a double knot and uneven spans.
const std::vector<double> custom_knots{0, 0, 0, 0, 0.1, 0.4, 0.4, 1, 1, 1, 1};

class CustomVector : public ::testing::Test {
  protected:
    CustomVector() {
        open_text(editor_, sample_text);
        run(SetKnots{.knots = custom_knots});
    }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }

    // Whether `part` can be had from `whole` by leaving values out.
    static bool is_part(const std::vector<double>& part, const std::vector<double>& whole) {
        return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
    }

    Editor editor_;
};

TEST_F(CustomVector, pitfall_17_survives_edits_of_points_weights_and_entries) {
    const auto expect_custom = [this](const char* after) {
        EXPECT_EQ(knots(editor_), custom_knots) << after;
        EXPECT_EQ(curve(editor_).knots().kind(), core::KnotKind::custom) << after;
    };
    for (const Command& command : std::vector<Command>{
             MovePoints{.points = {1, 2}, .offset = {1.0, 1.0}}, SetPoint{.index = 0, .position = {9.0, 9.0}},
             SetWeight{.index = 3, .weight = 5.0}, SetKind{.kind = core::KnotKind::custom},
             RenameCurve{.index = 0, .name = "other"}, SetCurveColor{.index = 0, .color = core::DocumentColor{0, 0, 0}},
             Undo{}, Redo{}, Duplicate{.shift = 1.0}, Copy{}}) {
        EXPECT_TRUE(editor_.run(command)) << command.spec().name << ": " << editor_.state().message.text;
        expect_custom(command.spec().name);
    }
    EXPECT_TRUE(type("paste"));
    expect_custom("paste");
}

TEST_F(CustomVector, pitfall_17_gains_one_knot_with_an_added_point) {
    for (std::size_t index = 0; index <= 7; ++index) {
        ASSERT_TRUE(run(AddPoint{.index = index, .position = {1.0, 1.0}}));
        EXPECT_EQ(knots(editor_).size(), custom_knots.size() + 1) << index;
        EXPECT_TRUE(is_part(custom_knots, knots(editor_))) << index;
        run(Undo{});
    }
}

TEST_F(CustomVector, pitfall_17_loses_one_knot_with_a_deleted_point) {
    for (std::size_t index = 0; index <= 6; ++index) {
        ASSERT_TRUE(run(DeletePoints{.points = {index}})) << editor_.state().message.text;
        EXPECT_EQ(knots(editor_).size(), custom_knots.size() - 1) << index;
        EXPECT_TRUE(is_part(knots(editor_), custom_knots)) << index;
        run(Undo{});
    }
}

TEST_F(CustomVector, pitfall_17_keeps_its_values_in_another_degree) {
    EXPECT_TRUE(run(SetDegree{.degree = 4}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0, 0.1, 0.1, 0.4, 0.4, 0.4, 1, 1, 1, 1, 1}));
    run(Undo{});
    EXPECT_TRUE(run(SetDegree{.degree = 2}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0.1, 0.4, 1, 1, 1}));
}

TEST_F(CustomVector, pitfall_17_is_never_put_into_order_silently) {
    EXPECT_FALSE(run(SetKnots{.knots = {0, 0, 0, 0, 0.4, 0.1, 0.4, 1, 1, 1, 1}}));
    EXPECT_EQ(editor_.state().message.text, "knot 5 is 0.1, less than knot 4, which is 0.4; knots must not decrease");
    EXPECT_FALSE(run(SetKnot{.index = 4, .u = 0.7}));
    EXPECT_EQ(knots(editor_), custom_knots);
}

}  // namespace
}  // namespace batten::editor
