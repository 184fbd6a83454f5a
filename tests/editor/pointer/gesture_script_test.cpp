#include "app/editor/pointer/gesture_script.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/editor.h"
#include "app/editor/pointer/canvas_mode.h"
#include "app/editor/pointer/plot_mode.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {

namespace {

const PicturePlaces places{{100.0, 50.0}, {100.0, 700.0}, {1000.0, 260.0}};

/// Makes frames of a gesture as the window would, without one.
class Player {
  public:
    Player(Editor& editor, ScriptedGesture gesture)
        : editor_(editor), gesture_(gesture), start_px_(start_of(gesture, editor.state(), places)) {}

    void play_frames(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) perform(scripted_frame(gesture_, frame_++, start_px_, editor_.state()));
    }
    void end() { perform(last_frame(gesture_, start_px_)); }

  private:
    void perform(const ScriptedFrame& frame) {
        CommandQueue queue;
        for (const Command& command : frame.commands) queue.run(command);
        for (PointerEvent event : frame.pointer_events) {
            if (gesture_ == ScriptedGesture::drag_knot) {
                event.position_px -= places.plot_origin_px;
                plot_ = step_plot(plot_, event, editor_.state(), places.plot_size_px, queue);
            } else {
                event.position_px -= places.canvas_origin_px;
                canvas_ = step_canvas(canvas_, event, editor_.state(), queue);
            }
        }
        editor_.perform(queue);
    }

    Editor& editor_;
    ScriptedGesture gesture_;
    glm::dvec2 start_px_;
    std::size_t frame_ = 0;
    CanvasMode canvas_;
    PlotMode plot_;
};

Editor shown_sample() {
    Editor editor;
    open_text(editor, sample_text);
    editor.change(ResizeCanvas{{1000.0, 600.0}});
    return editor;
}

TEST(GestureScript, drags_the_middle_control_point_a_little_way) {
    Editor editor = shown_sample();
    const core::Curve before = *editor.state().active_curve();
    Player player(editor, ScriptedGesture::drag);
    for (std::size_t frames : {3U, 17U}) {
        player.play_frames(frames);
        ASSERT_TRUE(is_under_way(ScriptedGesture::drag, editor.state()));
        const std::size_t middle = before.control_points().size() / 2;
        const core::Curve& after = *editor.state().active_curve();
        for (std::size_t i = 0; i < before.control_points().size(); ++i) {
            const double moved = core::distance(before.control_points()[i], after.control_points()[i]);
            // By whole pixels.
            EXPECT_NEAR(moved * editor.state().view.camera.scale, i == middle ? 24.0 : 0.0, i == middle ? 0.75 : 1e-9);
        }
    }
    player.end();
    EXPECT_FALSE(editor.state().preview.has_value());
    EXPECT_FALSE(editor.state().history.can_undo());
}

TEST(GestureScript, drags_the_middle_knot) {
    Editor editor = shown_sample();
    Player player(editor, ScriptedGesture::drag_knot);
    player.play_frames(3);
    EXPECT_TRUE(is_under_way(ScriptedGesture::drag_knot, editor.state()));
    const auto before = editor.state().history.present().active_curve()->curve->knots().stored();
    const auto after = editor.state().active_curve()->knots().stored();
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i] != after[i], i == before.size() / 2);
}

TEST(GestureScript, inserts_a_knot_and_undoes_it) {
    Editor editor = shown_sample();
    const std::size_t before = editor.state().active_curve()->knots().size();
    Player player(editor, ScriptedGesture::insert_knot);
    player.play_frames(3);
    EXPECT_EQ(editor.state().active_curve()->knots().size(), before + 1);
    player.play_frames(1);
    EXPECT_EQ(editor.state().active_curve()->knots().size(), before);
    EXPECT_EQ(editor.state().history.redo_count(), 1U);
    EXPECT_TRUE(is_under_way(ScriptedGesture::insert_knot, editor.state()));
}

TEST(GestureScript, pans_around_and_back) {
    Editor editor = shown_sample();
    Player player(editor, ScriptedGesture::pan);
    player.play_frames(3);
    const glm::dvec2 begin = editor.state().view.camera.center;
    player.play_frames(24);
    const double half_way = glm::distance(begin, editor.state().view.camera.center);
    EXPECT_NEAR(half_way * editor.state().view.camera.scale, 240.0, 1e-6);
    player.play_frames(24);
    EXPECT_NEAR(glm::distance(begin, editor.state().view.camera.center), 0.0, 1e-9);
}

TEST(GestureScript, zooms_in_and_out_again) {
    Editor editor = shown_sample();
    const double scale = editor.state().view.camera.scale;
    Player player(editor, ScriptedGesture::zoom);
    player.play_frames(2 + 12);
    EXPECT_NEAR(editor.state().view.camera.scale, scale * std::pow(1.15, 12), 1e-9 * scale);
    player.play_frames(12);
    EXPECT_NEAR(editor.state().view.camera.scale, scale, 1e-9 * scale);
}

TEST(GestureScript, plays_the_parameter) {
    Editor editor = shown_sample();
    Player player(editor, ScriptedGesture::play);
    EXPECT_FALSE(is_under_way(ScriptedGesture::play, editor.state()));
    player.play_frames(10);
    EXPECT_TRUE(editor.state().view.playback.is_playing);
}

TEST(GestureScript, does_the_same_on_an_empty_canvas) {
    for (const auto& entry : core::Names<ScriptedGesture>::table) {
        Editor editor;
        editor.change(ResizeCanvas{{1000.0, 600.0}});
        EXPECT_EQ(start_of(entry.value, editor.state(), places), glm::dvec2(600.0, 350.0));
        Player player(editor, entry.value);
        player.play_frames(6);
        player.end();
        EXPECT_EQ(editor.state().active_curve(), nullptr);
        EXPECT_FALSE(editor.state().message.is_error);
    }
}

}  // namespace

}  // namespace batten::editor
