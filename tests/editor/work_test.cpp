#include "app/editor/work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "app/editor/commands/analysis_commands.h"
#include "app/editor/commands/fitting_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/scene/canvas_scene.h"
#include "app/editor/typed_command.h"
#include "core/curve/knot_kinds.h"
#include "core/document/native_file.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

namespace fs = std::filesystem;

// A gate in which a thread stands until it is opened.
class Gate {
  public:
    void pass() {
        std::unique_lock lock(mutex_);
        if (admitted_ > 0) {
            --admitted_;
            return;
        }
        ++waiting_;
        changed_.notify_all();
        changed_.wait(lock, [&] { return is_open_; });
        --waiting_;
    }
    void open() {
        const std::lock_guard lock(mutex_);
        is_open_ = true;
        changed_.notify_all();
    }
    // Lets so many pass it without waiting.
    void admit(int count) {
        const std::lock_guard lock(mutex_);
        admitted_ = count;
    }
    void close() {
        const std::lock_guard lock(mutex_);
        is_open_ = false;
    }
    void await_someone() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return waiting_ > 0 || is_open_; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool is_open_ = false;
    int waiting_ = 0;
    int admitted_ = 0;
};

void await(const Work& work) {
    while (!work.wait_for(std::chrono::seconds(1))) continue;
}

TEST(Work, is_done_on_a_copy_of_the_state) {
    EditorState state;
    state.message.text = "before";
    Work work(
        state,
        [](EditorState& copy) {
            copy.message.text += " and after";
            copy.progress(0.25);
            return true;
        },
        [] {});
    await(work);
    EXPECT_EQ(work.share(), 0.25);
    EXPECT_EQ(state.message.text, "before");
    const Outcome<WorkResult> result = work.take();
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->is_done);
    EXPECT_EQ(result->state.message.text, "before and after");
    EXPECT_FALSE(result->state.progress);
}

TEST(Work, wakes_where_a_percentage_changes_and_at_the_end) {
    std::atomic<int> wakes = 0;
    Work work(
        EditorState(),
        [](EditorState& copy) {
            for (int i = 1; i <= 1000; ++i) copy.progress(0.0001 * i);
            return true;
        },
        [&] { ++wakes; });
    await(work);
    static_cast<void>(work.take());
    EXPECT_GE(wakes, 11);
    EXPECT_LE(wakes, 12) << "0 to 10 percent, and the end, which may be just now";
}

TEST(Work, stops_where_it_tells_how_far_it_is) {
    Gate gate;
    bool went_on = false;
    Work work(
        EditorState(),
        [&](EditorState& copy) {
            gate.pass();
            copy.progress(0.5);
            went_on = true;
            return true;
        },
        [] {});
    EXPECT_FALSE(work.is_finished());
    EXPECT_EQ(work.share(), std::nullopt);
    work.cancel();
    gate.open();
    await(work);
    EXPECT_EQ(work.take().error(), "canceled; nothing has changed");
    EXPECT_FALSE(went_on);
}

TEST(Work, has_no_result_where_it_was_canceled_without_noticing) {
    Gate gate;
    Work work(
        EditorState(), [&](EditorState&) { return gate.pass(), true; }, [] {});
    work.cancel();
    gate.open();
    await(work);
    EXPECT_FALSE(work.take());
}

TEST(Work, goes_on_to_its_end_once_it_has_told_that_all_is_done) {
    Gate gate;
    Work work(
        EditorState(),
        [&](EditorState& copy) {
            copy.progress(1.0);
            gate.pass();
            copy.progress(1.0);
            return true;
        },
        [] {});
    gate.await_someone();
    work.cancel();
    gate.open();
    await(work);
    EXPECT_TRUE(work.take());
}

TEST(Work, that_lacks_memory_says_so) {
    Work work(
        EditorState(), [](EditorState&) -> bool { throw std::bad_alloc(); }, [] {});
    await(work);
    EXPECT_EQ(work.take().error(), "there is not enough memory; nothing has changed");
}

TEST(Work, hands_over_the_points_that_are_read) {
    Gate gate;
    Work work(
        EditorState(),
        [&](EditorState& copy) {
            copy.points_read(std::vector{core::Point(1.0, 2.0), core::Point(3.0, 4.0)});
            gate.pass();
            copy.points_read(std::vector{core::Point(5.0, 6.0)});
            return true;
        },
        [] {});
    gate.await_someone();
    std::vector<core::Point> points{{1.0, 2.0}, {3.0, 4.0}};
    EXPECT_EQ(work.sketch().points(), points);
    gate.open();
    await(work);
    points.emplace_back(5.0, 6.0);
    EXPECT_EQ(work.sketch().points(), points);
    EXPECT_FALSE(work.take()->state.points_read);
}

TEST(Work, that_nobody_waits_for_is_stopped) {
    std::atomic<bool> has_begun = false;
    const auto run = [&](EditorState& copy) {
        for (;;) {
            has_begun = true;
            copy.progress(0.0);
        }
        return true;
    };
    const Work work(EditorState(), run, [] {});
    while (!has_begun) std::this_thread::yield();
}

// An editor whose desktop can be woken; what is at work stands before its gate as soon as it tells how far it is.
class BesideTheInterface : public ::testing::Test {
  protected:
    BesideTheInterface() {
        Desktop desktop;
        desktop.wake = [this] { gate_.pass(); };
        editor_ = std::make_unique<Editor>(std::move(desktop));
    }
    ~BesideTheInterface() override {
        gate_.open();
        editor_.reset();
    }

    // A file that is read in many blocks, with one curve called `name`.
    fs::path large_file(const std::string& file, const std::string& name) const {
        std::string text =
            R"({"format":"batten","version":1,"ballast":")" + std::string(2'000'000, 'x') + R"(","curves":[{"name":")";
        text.append(name).append(R"(","degree":1,"knots":[0,0,1,1],"points":[[0,0],[1,1]]}]})");
        return folder_.write(file, text);
    }

    const EditorState& state() const { return editor_->state(); }

    // Lets what is at work go on to its end.
    void finish() {
        gate_.open();
        while (state().at_work) {
            editor_->follow_work();
            std::this_thread::yield();
        }
    }

    TemporaryFolder folder_;
    Gate gate_;
    std::unique_ptr<Editor> editor_;
};

TEST_F(BesideTheInterface, a_large_file_is_opened) {
    const fs::path path = large_file("large.json", "long");
    EXPECT_FALSE(editor_->run(Open{.path = path})) << "not yet";
    EXPECT_EQ(state().dialog, Dialog::at_work);
    EXPECT_EQ(state().at_work->text, "Opening large.json");
    EXPECT_TRUE(document(*editor_).curves.empty());
    EXPECT_TRUE(editor_->log().empty());
    gate_.await_someone();
    EXPECT_TRUE(editor_->follow_work());
    EXPECT_NEAR(state().at_work->share.value(), 0.13, 0.01) << "one block of 256 KiB";
    EXPECT_FALSE(editor_->follow_work()) << "nothing has changed";
    finish();
    EXPECT_EQ(document(*editor_).curves.at(0).name, "long");
    EXPECT_EQ(state().path, path);
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(state().message, (Message{"Opened large.json", false}));
    EXPECT_EQ(editor_->log().size(), 1U);
}

TEST_F(BesideTheInterface, canceling_leaves_everything_as_it_was) {
    open_text(*editor_, bezier_text);
    const fs::path before = state().path;
    editor_->run(Open{.path = large_file("large.json", "long")});
    CommandQueue queue;
    queue.cancel_work();
    editor_->perform(queue);
    EXPECT_TRUE(state().at_work->is_canceled);
    finish();
    EXPECT_EQ(document(*editor_).curves.at(0).name, "arch");
    EXPECT_EQ(state().path, before);
    EXPECT_EQ(state().dialog, Dialog::none);
    EXPECT_EQ(state().message, (Message{"Opening large.json: canceled; nothing has changed", false}));
    EXPECT_EQ(editor_->log().size(), 1U);
}

// A file with one curve of many points (i, sin i / 100), and ballast, which is read after it.
std::string text_of_wave(std::size_t count) {
    core::Document document;
    core::DocumentCurve& item = document.curves.emplace_back();
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i)
        points.emplace_back(static_cast<double>(i), std::sin(0.01 * static_cast<double>(i)));
    item.curve = std::make_shared<const core::Curve>(
        core::Curve::make(core::make_knots(core::KnotKind::clamped_uniform, 3, count).value(), points, {}).value());
    document.unknown_members = R"({"ballast":")" + std::string(2'000'000, 'x') + R"("})";
    return core::format_document(document);
}

TEST_F(BesideTheInterface, a_file_is_sketched_while_it_is_read) {
    open_text(*editor_, bezier_text);
    CanvasMode mode;
    SceneCache cache;
    editor_->change(ResizeCanvas{{800.0, 600.0}});
    const std::size_t shown_before = canvas_scene(state(), mode, cache).commands.size();
    const View view = state().view;
    gate_.admit(3);  // and the fourth block is read, when the wave has long ended
    editor_->run(Open{.path = folder_.write("wave.json", text_of_wave(5000))});
    gate_.await_someone();
    EXPECT_TRUE(editor_->follow_work());
    const std::vector<core::Point>& points = state().at_work->sketch.points();
    ASSERT_EQ(points.size(), 5000U);
    EXPECT_EQ(points[4999], core::Point(4999.0, std::sin(49.99)));
    EXPECT_EQ(document(*editor_).curves.at(0).name, "arch");
    EXPECT_EQ(state().view.camera, view.camera);
    const render::DrawList sketched = canvas_scene(state(), mode, cache);
    ASSERT_EQ(sketched.commands.size(), 5000U);
    EXPECT_NEAR(std::get<render::Marker>(sketched.commands.front()).center.x, 56.0, 1e-3);
    EXPECT_NEAR(std::get<render::Marker>(sketched.commands.back()).center.x, 800.0 - 56.0, 1e-3);
    editor_->cancel_work();
    finish();
    EXPECT_EQ(document(*editor_).curves.at(0).name, "arch");
    EXPECT_EQ(canvas_scene(state(), mode, cache).commands.size(), shown_before);
}

// Each tells how far it is long before its end, and stops there.
class LongCommands : public BesideTheInterface, public ::testing::WithParamInterface<const char*> {};

TEST_P(LongCommands, tell_how_far_they_are_and_can_be_stopped) {
    std::vector<core::Point> wave;
    for (int i = 0; i < 3000; ++i) wave.emplace_back(0.01 * i, std::sin(0.01 * i));
    core::Document document;
    core::DocumentCurve& item = document.curves.emplace_back();
    item.name = "wave";
    item.curve = std::make_shared<const core::Curve>(
        core::Curve::make(core::make_knots(core::KnotKind::clamped_uniform, 3, wave.size()).value(), wave, {}).value());
    const fs::path path = folder_.write("wave.json", core::format_document(document));
    gate_.open();
    editor_->run(Open{.path = path});
    finish();
    gate_.close();
    const auto run = parse_typed_command(GetParam(), state());
    ASSERT_TRUE(run);
    EXPECT_FALSE(editor_->run(*run)) << "not yet";
    gate_.await_someone();
    EXPECT_TRUE(editor_->follow_work());
    EXPECT_LT(state().at_work->share.value(), 0.1);
    CommandQueue queue;
    queue.cancel_work();
    editor_->perform(queue);
    finish();
    EXPECT_TRUE(state().message.text.ends_with(": canceled; nothing has changed")) << state().message.text;
    EXPECT_EQ(editor_->log().size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Work, LongCommands,
                         ::testing::Values("fair 0.001", "offset 0.1 1e-6", "remove-knots 0.001", "reduce 1"));

TEST_F(BesideTheInterface, a_broken_file_is_refused_and_leaves_the_document) {
    open_text(*editor_, bezier_text);
    const fs::path path = large_file("large.json", R"(", "x": [)");
    editor_->run(Open{.path = path});
    EXPECT_TRUE(state().at_work);
    finish();
    EXPECT_EQ(document(*editor_).curves.at(0).name, "arch");
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(state().message.text.find("large.json: line 1, column"), 0U) << state().message.text;
}

TEST_F(BesideTheInterface, the_view_follows_meanwhile) {
    editor_->run(Open{.path = large_file("large.json", "long")});
    editor_->change(ResizeCanvas{{640.0, 480.0}});
    editor_->change(SetInterfaceScale{2.0});
    EXPECT_EQ(state().view.camera.size_px, glm::dvec2(640.0, 480.0));
    finish();
    EXPECT_EQ(state().view.camera.size_px, glm::dvec2(640.0, 480.0));
    EXPECT_EQ(state().view.interface_scale, 2.0);
}

TEST_F(BesideTheInterface, commands_wait_for_its_end_in_order) {
    editor_->run(Open{.path = large_file("large.json", "long")});
    EXPECT_FALSE(editor_->run(AddFile{.path = folder_.write("arch.json", bezier_text)}));
    EXPECT_FALSE(editor_->run(ToggleTheme{}));
    EXPECT_TRUE(document(*editor_).curves.empty());
    finish();
    EXPECT_EQ(document(*editor_).curves.at(1).name, "arch");
    EXPECT_EQ(state().view.theme, ThemeName::light);
    EXPECT_EQ(editor_->log().size(), 3U);
}

TEST_F(BesideTheInterface, leaving_stops_it) {
    editor_->run(Open{.path = large_file("large.json", "long")});
    editor_->run(Quit{});
    finish();
    EXPECT_TRUE(state().wants_quit);
    EXPECT_TRUE(document(*editor_).curves.empty());
}

TEST_F(BesideTheInterface, what_is_small_is_done_at_once) {
    EXPECT_TRUE(editor_->run(Open{.path = folder_.write("arch.json", bezier_text)}));
    EXPECT_TRUE(editor_->run(FindSelfIntersections{}));
    EXPECT_EQ(editor_->log().size(), 2U);
}

std::vector<core::Point> spiral(std::size_t count) {
    std::vector<core::Point> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 0.01 * static_cast<double>(i);
        points.emplace_back(t * std::cos(t), t * std::sin(t));
    }
    return points;
}

TEST_F(BesideTheInterface, a_save_that_is_canceled_leaves_the_old_file_alone) {
    const fs::path path = folder_.write("long.json", "old");
    ASSERT_TRUE(editor_->run(AddPolyline{.points = spiral(40'000), .closed = false})) << "which is not at work beside";
    EXPECT_FALSE(editor_->run(SaveAs{.path = path}));
    EXPECT_EQ(state().at_work->text, "Saving long.json");
    gate_.await_someone();
    editor_->cancel_work();
    finish();
    EXPECT_EQ(core::read_text(path), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
    EXPECT_TRUE(state().is_modified());
    EXPECT_TRUE(state().path.empty());
    EXPECT_TRUE(editor_->run(SaveAs{.path = path}) || (finish(), true));
    EXPECT_EQ(core::load_document(path)->curves.at(0).curve->control_points().size(), 40'000U);
    EXPECT_FALSE(state().is_modified());
}

TEST_F(BesideTheInterface, a_copy_that_is_canceled_leaves_the_old_file_alone) {
    const fs::path path = folder_.write("long.dxf", "old");
    ASSERT_TRUE(editor_->run(AddPolyline{.points = spiral(40'000), .closed = false}));
    EXPECT_FALSE(editor_->run(SaveAs{.path = path}));
    editor_->cancel_work();
    finish();
    const bool is_canceled = state().message.text == "Saving long.dxf: canceled; nothing has changed";
    EXPECT_EQ(core::read_text(path) == "old", is_canceled) << state().message.text;
}

// Whether it was so far when it was canceled, or not.
TEST_F(BesideTheInterface, a_copy_is_not_canceled_once_its_file_changes) {
    const fs::path path = folder_.write("long.dxf", "old");
    ASSERT_TRUE(editor_->run(AddPolyline{.points = spiral(40'000), .closed = false}));
    EXPECT_FALSE(editor_->run(SaveAs{.path = path}));
    gate_.await_someone();
    EXPECT_EQ(core::read_text(path), "old");
    editor_->cancel_work();
    finish();
    EXPECT_EQ(state().message.text.find("Exported long.dxf"), 0U) << state().message.text;
    EXPECT_NE(core::read_text(path), "old");
}

TEST_F(BesideTheInterface, it_comes_to_the_same_as_without) {
    const FitPoints fit{.count = 300,
                        .points = spiral(20'000),
                        .degree = 3,
                        .closed = false,
                        .smoothing = 0.0,
                        .start = std::nullopt,
                        .end = std::nullopt,
                        .natural = false};
    Editor other;
    EXPECT_TRUE(other.run(fit));
    editor_->run(fit);
    finish();
    EXPECT_EQ(curve(*editor_), curve(other));
    EXPECT_EQ(state().message, other.state().message);
    EXPECT_EQ(state().history.undo_label(), "Fit curve to points");
}

}  // namespace
}  // namespace batten::editor
