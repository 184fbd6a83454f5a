// Every lesson is gone through as a student would: its steps begin, its tasks are not done then, and can be done.

#include <gtest/gtest.h>

#include <filesystem>

#include "app/editor/commands/lesson_commands.h"
#include "app/editor/editor.h"
#include "app/editor/example_files.h"
#include "app/editor/lesson/lesson_file.h"

namespace batten::editor {
namespace {

class Lessons : public ::testing::TestWithParam<std::filesystem::path> {
  protected:
    void SetUp() override { ASSERT_TRUE(editor_.run(OpenLesson{GetParam().string()})) << message(); }

    const EditorState& state() const { return editor_.state(); }
    std::string message() const { return state().message.text; }

    Editor editor_;
};

TEST_P(Lessons, can_be_worked_through) {
    for (std::size_t step = 0;; ++step) {
        ASSERT_EQ(state().lesson->step, step);
        const LessonStep& present = state().lesson->present();
        EXPECT_FALSE(present.text.empty()) << step;
        EXPECT_EQ(present.task.empty(), present.solution.empty()) << "step " << step + 1;
        if (!present.task.empty()) {
            EXPECT_FALSE(is_done(*state().lesson, state())) << "step " << step + 1 << " has nothing to do";
            EXPECT_TRUE(editor_.run(SolveTask{})) << "step " << step + 1 << ": " << message();
            for (const CheckResult& result : results_of(*state().lesson, state()))
                EXPECT_TRUE(result.holds) << "step " << step + 1 << ": " << result.sentence;
        }
        if (state().lesson->is_last()) break;
        ASSERT_TRUE(editor_.run(NextStep{})) << "step " << step + 2 << ": " << message();
    }
}

TEST_P(Lessons, can_be_gone_back_through) {
    while (!state().lesson->is_last()) ASSERT_TRUE(editor_.run(NextStep{})) << message();
    while (state().lesson->step > 0) ASSERT_TRUE(editor_.run(PreviousStep{})) << message();
    EXPECT_TRUE(editor_.run(NextStep{}) || state().lesson->is_last()) << message();
}

TEST_P(Lessons, are_written_as_they_are_read) {
    const Outcome<Lesson> lesson = load_lesson(GetParam());
    ASSERT_TRUE(lesson) << lesson.error();
    const std::string text = format_lesson(*lesson);
    const Outcome<Lesson> again = parse_lesson(text, lesson->name);
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(format_lesson(*again), text);
}

INSTANTIATE_TEST_SUITE_P(All, Lessons, ::testing::ValuesIn(example_files(BATTEN_LESSONS)), [](const auto& tested) {
    std::string name = tested.param.stem().string();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace batten::editor
