#include "app/platform/key_queue.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <string>

namespace batten::platform {

namespace {

class KeyQueueTest : public testing::Test {
  protected:
    void key(int code, int action, int modifiers = 0) { queue_.push({code, 0, action, modifiers}); }
    void down(int code, int modifiers = 0) { key(code, GLFW_PRESS, modifiers); }
    void up(int code, int modifiers = 0) { key(code, GLFW_RELEASE, modifiers); }

    void text(char character) {
        KeyEvent event;
        event.character = static_cast<unsigned char>(character);
        queue_.push(event);
    }

    void strike(char letter) {
        const int code = letter - 'a' + GLFW_KEY_A;
        down(code);
        text(letter);
        up(code);
    }

    /// The coming frames: "v" for typed text, "+V" and "-V" for a key down and up, "*V" for a repeat; "C" is Ctrl, "<"
    /// Left, "B" Backspace.
    std::vector<std::string> frames() {
        std::vector<std::string> frames;
        while (!queue_.is_empty()) {
            std::string& frame = frames.emplace_back();
            for (const KeyEvent& event : queue_.take_portion())
                frame.append(frame.empty() ? "" : " ").append(name_of(event));
            EXPECT_FALSE(frame.empty());
        }
        return frames;
    }

    KeyQueue queue_;

  private:
    static std::string name_of(const KeyEvent& event) {
        if (event.character != 0) return std::string(1, static_cast<char>(event.character));
        const char action = event.action == GLFW_RELEASE ? '-' : event.action == GLFW_REPEAT ? '*' : '+';
        const char key = event.key == GLFW_KEY_LEFT_CONTROL ? 'C'
                         : event.key == GLFW_KEY_LEFT       ? '<'
                         : event.key == GLFW_KEY_BACKSPACE  ? 'B'
                                                            : static_cast<char>(event.key);
        return {action, key};
    }
};

using Frames = std::vector<std::string>;

TEST_F(KeyQueueTest, keeps_ctrl_held_for_the_frame_that_sees_the_key) {
    down(GLFW_KEY_LEFT_CONTROL);
    EXPECT_EQ(frames(), (Frames{"+C"}));
    down(GLFW_KEY_V, GLFW_MOD_CONTROL);
    up(GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL);
    up(GLFW_KEY_V);
    EXPECT_EQ(frames(), (Frames{"+V", "-C -V"}));
}

TEST_F(KeyQueueTest, shows_a_whole_shortcut_of_one_slow_frame_in_whatever_order_its_keys_go_up) {
    for (const bool ctrl_first : {true, false}) {
        down(GLFW_KEY_LEFT_CONTROL);
        down(GLFW_KEY_A, GLFW_MOD_CONTROL);
        up(ctrl_first ? GLFW_KEY_LEFT_CONTROL : GLFW_KEY_A);
        up(ctrl_first ? GLFW_KEY_A : GLFW_KEY_LEFT_CONTROL);
        EXPECT_EQ(frames(), ctrl_first ? (Frames{"+C +A", "-C -A"}) : (Frames{"+C +A", "-A -C"}));
    }
}

TEST_F(KeyQueueTest, does_not_take_a_letter_for_a_shortcut_that_comes_after) {
    strike('v');
    down(GLFW_KEY_LEFT_CONTROL);
    down(GLFW_KEY_A, GLFW_MOD_CONTROL);
    EXPECT_EQ(frames(), (Frames{"+V v", "-V +C +A"}));
}

TEST_F(KeyQueueTest, keeps_text_behind_the_keys_before_it) {
    down(GLFW_KEY_BACKSPACE);
    up(GLFW_KEY_BACKSPACE);
    strike('x');
    EXPECT_EQ(frames(), (Frames{"+B", "-B +X x", "-X"}));
    down(GLFW_KEY_LEFT);
    down(GLFW_KEY_BACKSPACE);
    EXPECT_EQ(frames(), (Frames{"+<", "+B"})) << "a text field answers to one of them in a frame";
}

TEST_F(KeyQueueTest, shows_letters_together) {
    down(GLFW_KEY_A);
    text('a');
    down(GLFW_KEY_B);
    text('b');
    up(GLFW_KEY_A);
    EXPECT_EQ(frames(), (Frames{"+A a +B b", "-A"}));
}

TEST_F(KeyQueueTest, keeps_a_key_down_for_a_frame) {
    down(GLFW_KEY_I);
    up(GLFW_KEY_I);
    down(GLFW_KEY_I);
    up(GLFW_KEY_I);
    EXPECT_EQ(frames(), (Frames{"+I", "-I", "+I", "-I"}));
}

TEST_F(KeyQueueTest, does_not_lag_behind_a_key_that_repeats) {
    down(GLFW_KEY_LEFT);
    EXPECT_EQ(frames(), (Frames{"+<"}));
    for (int i = 0; i < 10; ++i) key(GLFW_KEY_LEFT, GLFW_REPEAT);
    up(GLFW_KEY_LEFT);
    EXPECT_EQ(frames(), (Frames{"*<", "-<"}));
}

TEST_F(KeyQueueTest, notes_what_the_last_key_prints) {
    down(GLFW_KEY_3, GLFW_MOD_CONTROL);
    queue_.note_printed('+');
    EXPECT_EQ(queue_.take_portion().at(0).printed, static_cast<unsigned>('+'));
    text('a');
    queue_.note_printed('+');
    EXPECT_EQ(queue_.take_portion().at(0).printed, 0U);
    queue_.note_printed('+');
    EXPECT_TRUE(queue_.is_empty());
}

}  // namespace

}  // namespace batten::platform
