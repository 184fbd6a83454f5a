#include "app/editor/commands/lesson_commands.h"

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/shape_view_commands.h"
#include "app/editor/lesson/lesson_file.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

constexpr const char* lesson_text = R"({
  "format": "batten-lesson", "version": 1, "title": "Knots", "text": "What a knot does.",
  "notation": {"points": "V", "parameter": "t"},
  "document": {"format": "batten", "version": 1, "curves": [
    {"name": "arch", "degree": 3, "knots": [0,0,0,0,1,1,1,1], "points": [[0,0],[1,2],[3,2],[4,0]]}]},
  "view": {"overlays": ["polygon", "knots"], "parameter": 0.25},
  "steps": [
    {"text": "One piece."},
    {"text": "A knot is inserted.", "do": [["insert-knot", 0.5]], "view": {"overlays": ["polygon"], "parameter": 0.75}},
    {"text": "Once more.", "task": "Make the knot 0.5 double.",
     "checks": [{"check": "multiplicity", "knot": 0.5, "is": 2}], "solution": [["insert-knot", 0.5]]},
    {"text": "Another curve.", "document": {"format": "batten", "version": 1, "curves": [
      {"degree": 1, "knots": [0,0,1,1], "points": [[0,0],[1,1]]}]}}
  ]})";

class LessonCommands : public ::testing::Test {
  protected:
    LessonCommands() : editor_(desktop()) { folder_.write("knots.json", lesson_text); }

    const EditorState& state() const { return editor_.state(); }
    const core::Curve& curve() const { return *state().active_curve(); }
    bool run(const Command& command) { return editor_.run(command); }
    void open() { ASSERT_TRUE(run(OpenLesson{"knots"})) << state().message.text; }

    TemporaryFolder folder_;
    Editor editor_;

  private:
    Desktop desktop() const {
        Desktop desktop;
        desktop.lessons = folder_.path();
        return desktop;
    }
};

TEST_F(LessonCommands, begin_with_document_view_and_notation) {
    open();
    EXPECT_EQ(curve().degree(), 3);
    EXPECT_EQ(state().parameter(), 0.25);
    EXPECT_TRUE(state().view.overlays.is_shown(Overlay::knots));
    EXPECT_FALSE(state().view.overlays.is_shown(Overlay::grid));
    EXPECT_EQ(state().view.notation.points, PointLetter::V);
    EXPECT_EQ(state().view.usual_notation, Notation{});
    EXPECT_EQ(state().message.text, "Step 1 of 4");
    EXPECT_FALSE(state().is_modified());
    EXPECT_TRUE(results_of(*state().lesson, state()).empty());
    EXPECT_FALSE(is_done(*state().lesson, state()));
}

TEST_F(LessonCommands, go_forward_through_acts_views_and_documents) {
    open();
    EXPECT_TRUE(run(NextStep{}));
    EXPECT_EQ(curve().control_points().size(), 5U);
    EXPECT_EQ(state().parameter(), 0.75);
    EXPECT_FALSE(state().view.overlays.is_shown(Overlay::knots));
    EXPECT_TRUE(run(NextStep{}));
    EXPECT_FALSE(is_done(*state().lesson, state()));
    EXPECT_EQ(results_of(*state().lesson, state()).at(0).sentence, "the multiplicity of 1/2 is 1, not yet 2");
    EXPECT_TRUE(run(InsertKnot{.u = 0.5}));
    EXPECT_TRUE(is_done(*state().lesson, state()));
    EXPECT_TRUE(run(NextStep{}));
    EXPECT_EQ(curve().degree(), 1);
    EXPECT_EQ(state().view.notation.points, PointLetter::V);
    EXPECT_FALSE(run(NextStep{}));
    EXPECT_EQ(state().message.text, "this is the last step of the lesson");
    EXPECT_FALSE(state().message.is_error) << "a presenter may press once too often";
}

TEST_F(LessonCommands, go_back_to_what_stood_when_the_step_began) {
    open();
    run(NextStep{});
    run(NextStep{});
    run(InsertKnot{.u = 0.5});
    run(ToggleOverlay<Overlay::grid>{});
    EXPECT_TRUE(run(PutLine{.first = {0, 1}, .second = {1, 1}}));
    run(NextStep{});
    run(PreviousStep{});
    EXPECT_FALSE(state().view.shape.line) << "none was put before";
    EXPECT_EQ(state().lesson->step, 2U);
    EXPECT_EQ(curve().control_points().size(), 5U) << "as the step began";
    EXPECT_FALSE(state().view.overlays.is_shown(Overlay::grid));
    EXPECT_EQ(state().parameter(), 0.75);
    run(PreviousStep{});
    EXPECT_EQ(curve().control_points().size(), 5U);
    run(PreviousStep{});
    EXPECT_EQ(curve().control_points().size(), 4U);
    EXPECT_FALSE(run(PreviousStep{}));
    EXPECT_EQ(state().lesson->step, 0U);
    run(NextStep{});
    EXPECT_EQ(curve().control_points().size(), 5U) << "and forward again";
}

TEST_F(LessonCommands, show_how_a_task_is_done) {
    open();
    EXPECT_FALSE(run(SolveTask{}));
    EXPECT_EQ(state().message.text, "this step of the lesson has no task that could be shown");
    run(NextStep{});
    run(NextStep{});
    EXPECT_TRUE(run(SolveTask{}));
    EXPECT_TRUE(is_done(*state().lesson, state()));
    EXPECT_EQ(curve().control_points().size(), 6U);
}

TEST_F(LessonCommands, end_with_the_lesson_or_with_another_document) {
    EXPECT_FALSE(run(NextStep{}));
    EXPECT_EQ(state().message.text, "no lesson is open");
    open();
    run(CloseLesson{});
    EXPECT_FALSE(state().lesson);
    EXPECT_EQ(curve().degree(), 3);
    open();
    run(NewDocument{});
    EXPECT_FALSE(state().lesson);
}

TEST_F(LessonCommands, show_again_what_was_shown_before) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(ToggleOverlay<Overlay::continuity>{});
    ASSERT_TRUE(run(SetLevel{.level = 2})) << state().message.text;
    const Overlays shown = state().view.overlays;
    ASSERT_TRUE(shown.is_shown(Overlay::grid));
    open();
    run(NextStep{});
    EXPECT_FALSE(state().view.overlays.is_shown(Overlay::continuity));
    open();
    run(NextStep{});
    run(NextStep{});
    run(InsertKnot{.u = 0.5});
    run(ToggleOverlay<Overlay::hodograph>{});
    run(SetLevel{.level = 1});
    run(CloseLesson{});
    EXPECT_EQ(state().view.overlays, shown) << "not what the lesson shown before had";
    EXPECT_EQ(state().view.notation, Notation{});
    EXPECT_EQ(state().view.level, 2);
    EXPECT_EQ(curve().control_points().size(), 6U) << "the curves stay";
    EXPECT_TRUE(run(Undo{})) << "and what was done with them";
    EXPECT_EQ(curve().control_points().size(), 5U);
    EXPECT_EQ(state().view.overlays, shown);
}

TEST_F(LessonCommands, refuse_what_is_no_lesson) {
    EXPECT_FALSE(run(OpenLesson{"nothing"}));
    const auto refusal = [&](const char* text) {
        const auto path = folder_.write("broken.json", text);
        EXPECT_FALSE(run(OpenLesson{path.string()}));
        EXPECT_FALSE(state().lesson);
        return state().message.text;
    };
    EXPECT_EQ(refusal("{"),
              "broken.json: line 1, column 2: this is not JSON: unexpected end of input; expected string literal");
    EXPECT_EQ(refusal("[]"), "broken.json: : this must be an object");
    EXPECT_EQ(refusal(R"({"format": "batten-lesson", "version": 2})"),
              "broken.json: /version: this must be 1, the version that this program reads");
    EXPECT_EQ(refusal(R"({"format": "batten-lesson", "version": 1, "title": "T", "text": "t", "steps": []})"),
              "broken.json: /steps: this must be a list of at least one step");
    EXPECT_EQ(
        refusal(R"({"format": "batten-lesson", "version": 1, "title": "T", "text": "t", "steps": [{"text": 3}]})"),
        "broken.json: /steps/0/text: this must be a text");
    EXPECT_EQ(refusal(R"({"format": "batten-lesson", "version": 1, "title": "T", "text": "t",
        "steps": [{"text": "s", "task": "Do it."}]})"),
              "broken.json: /steps/0/task: this must be followed by checks");
    EXPECT_EQ(refusal(R"({"format": "batten-lesson", "version": 1, "title": "T", "text": "t",
        "steps": [{"text": "s", "color": 1}]})"),
              "broken.json: /steps/0/color: this member is not known");
}

TEST_F(LessonCommands, say_which_act_of_a_step_cannot_be_done) {
    const auto path = folder_.write("acts.json", R"({"format": "batten-lesson", "version": 1, "title": "T", "text": "t",
        "steps": [{"text": "s", "do": [["fly"]]}]})");
    EXPECT_FALSE(run(OpenLesson{path.string()}));
    EXPECT_EQ(state().message.text, "there is no command called 'fly'");
}

TEST_F(LessonCommands, write_what_was_read) {
    const Outcome<Lesson> lesson = parse_lesson(lesson_text, "knots");
    ASSERT_TRUE(lesson) << lesson.error();
    const std::string text = format_lesson(*lesson);
    const Outcome<Lesson> again = parse_lesson(text, "knots");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(format_lesson(*again), text);
    ASSERT_EQ(again->steps.size(), 4U);
    EXPECT_EQ(again->steps[1].acts, std::vector<std::string>{R"(["insert-knot",0.5])"});
    EXPECT_EQ(again->steps[2].checks.size(), 1U);
}

class Recording : public LessonCommands {
  protected:
    /// What was recorded, saved and opened again.
    Lesson saved() {
        const auto path = folder_.path() / "recorded.json";
        EXPECT_TRUE(run(SaveLesson{path})) << state().message.text;
        EXPECT_FALSE(state().recording);
        return load_lesson(path).value();
    }
};

TEST_F(Recording, makes_a_step_of_each_edit_and_replays_to_the_same_document) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    run(InsertKnot{.u = 0.3});
    run(InsertKnot{.u = 0.4});
    const core::Document made = state().history.present();
    const Lesson lesson = saved();
    EXPECT_EQ(lesson.title, "Mine");
    ASSERT_EQ(lesson.steps.size(), 3U);
    EXPECT_EQ(lesson.steps[1].acts, std::vector<std::string>{R"(["insert-knot",0.3])"});
    EXPECT_NE(lesson.steps[1].text.find("Inserted knot 0.3"), std::string::npos) << lesson.steps[1].text;
    run(OpenLesson{"recorded"});
    run(NextStep{});
    run(NextStep{});
    EXPECT_TRUE(has_same_content(state().history.present(), made));
}

TEST_F(Recording, forgets_what_is_undone_and_brings_back_what_is_redone) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    run(InsertKnot{.u = 0.3});
    run(InsertKnot{.u = 0.4});
    run(Undo{});
    run(Undo{});
    run(Redo{});
    const Lesson lesson = saved();
    ASSERT_EQ(lesson.steps.size(), 2U);
    EXPECT_EQ(lesson.steps[1].acts, std::vector<std::string>{R"(["insert-knot",0.3])"});
}

TEST_F(Recording, keeps_what_is_shown_as_it_is_and_not_as_a_switch) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    run(ToggleOverlay<Overlay::hodograph>{});
    const Lesson lesson = saved();
    ASSERT_EQ(lesson.steps.size(), 2U);
    EXPECT_TRUE(lesson.steps[1].acts.empty());
    ASSERT_TRUE(lesson.steps[1].view.overlays);
    const std::vector<Overlay>& shown = *lesson.steps[1].view.overlays;
    EXPECT_NE(std::find(shown.begin(), shown.end(), Overlay::hodograph), shown.end());
    for (int times = 0; times < 2; ++times) {
        run(OpenLesson{"recorded"});
        run(NextStep{});
        EXPECT_TRUE(state().view.overlays.is_shown(Overlay::hodograph)) << "whatever was shown before";
    }
}

TEST_F(Recording, forgets_what_is_undone_after_something_else_was_shown) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    run(InsertKnot{.u = 0.3});
    run(InsertKnot{.u = 0.4});
    run(ToggleOverlay<Overlay::hodograph>{});
    run(Undo{});
    ASSERT_EQ(state().recording->lesson.steps.size(), 3U) << "the first one, a knot, the hodograph";
    run(ToggleOverlay<Overlay::continuity>{});
    run(Redo{});
    const core::Document made = state().history.present();
    const Lesson lesson = saved();
    ASSERT_EQ(lesson.steps.size(), 5U);
    for (const LessonStep& step : lesson.steps) EXPECT_FALSE(step.document) << step.text;
    EXPECT_EQ(lesson.steps[1].acts, std::vector<std::string>{R"(["insert-knot",0.3])"});
    EXPECT_TRUE(lesson.steps[2].acts.empty());
    EXPECT_EQ(lesson.steps[4].acts, std::vector<std::string>{R"(["insert-knot",0.4])"});
    run(OpenLesson{"recorded"});
    for (int times = 0; times < 4; ++times) run(NextStep{});
    EXPECT_TRUE(has_same_content(state().history.present(), made));
}

TEST_F(Recording, keeps_the_parameter_of_a_step_that_is_undone) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    run(InsertKnot{.u = 0.3});
    run(SetParameter{.u = 0.375});
    run(Undo{});
    const Lesson lesson = saved();
    ASSERT_EQ(lesson.steps.size(), 1U);
    EXPECT_EQ(lesson.steps[0].view.parameter, 0.375);
}

TEST_F(Recording, says_what_the_lesson_is_about_once) {
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    EXPECT_EQ(state().recording->lesson.steps[0].text, "This is what it begins with.");
    run(DropRecording{});
    run(Open{.path = folder_.write("waves.json", R"({"format": "batten", "version": 1, "title": "Waves",
        "description": "A curve that waves.", "curves": []})")});
    run(RecordLesson{"Mine"});
    const Lesson lesson = saved();
    EXPECT_EQ(lesson.text, "A curve that waves.");
    EXPECT_EQ(lesson.steps[0].text, "Waves");
}

TEST_F(Recording, gives_the_last_step_the_text_that_is_told) {
    EXPECT_FALSE(run(DescribeStep{"Nothing."}));
    EXPECT_EQ(state().message.text, "no lesson is being recorded");
    run(Open{.path = folder_.write("sample.json", sample_text)});
    run(RecordLesson{"Mine"});
    EXPECT_TRUE(run(DescribeStep{"Before."}));
    run(InsertKnot{.u = 0.3});
    EXPECT_TRUE(run(DescribeStep{"A knot comes in: u_{4} = 0.3."}));
    EXPECT_EQ(state().message.text, "Step 2 of the lesson has its text now");
    run(InsertKnot{.u = 0.4});
    run(Undo{});
    const Lesson lesson = saved();
    ASSERT_EQ(lesson.steps.size(), 2U);
    EXPECT_EQ(lesson.steps[0].text, "Before.");
    EXPECT_EQ(lesson.steps[1].text, "A knot comes in: u_{4} = 0.3.");
    EXPECT_EQ(lesson.steps[1].acts, std::vector<std::string>{R"(["insert-knot",0.3])"});
}

TEST_F(Recording, is_one_at_a_time_and_can_be_dropped) {
    EXPECT_FALSE(run(SaveLesson{folder_.path() / "x.json"}));
    EXPECT_EQ(state().message.text, "no lesson is being recorded");
    run(RecordLesson{"Mine"});
    EXPECT_FALSE(run(RecordLesson{"Other"}));
    EXPECT_EQ(state().message.text, "a lesson is being recorded already");
    EXPECT_TRUE(run(DropRecording{}));
    EXPECT_FALSE(state().recording);
}

TEST(LessonDocuments, keep_the_forms_of_views) {
    const auto lesson_with = [](const std::string& forms) {
        return parse_lesson(R"({"format": "batten-lesson", "version": 1, "title": "Parts", "text": "Parts.", "document":
            {"format": "batten", "version": 1, "curves": [], "view": {"forms": )" +
                                forms + R"(}}, "steps": [{"text": "See them."}]})",
                            "parts");
    };
    const Outcome<Lesson> lesson = lesson_with(R"({"parts": 7})");
    ASSERT_TRUE(lesson) << lesson.error();
    EXPECT_NE(format_lesson(*lesson).find(R"("parts": 7)"), std::string::npos);
    EXPECT_EQ(lesson_with(R"({"parts": 0})").error(), "/document: /view/forms/parts: this must be from 1 to 200");
}

}  // namespace
}  // namespace batten::editor
