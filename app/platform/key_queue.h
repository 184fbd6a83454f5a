/// Typed keys on their way into frames: who looks at keys once a frame must not be shown two things at once.
#pragma once

#include <deque>
#include <vector>

namespace batten::platform {

/// A key, or a character of typed text, as GLFW reports it.
struct KeyEvent {
    int key = 0;
    int scancode = 0;
    int action = 0;
    int modifiers = 0;
    unsigned character = 0;  ///< not 0: typed text, and the other members have no meaning
    unsigned printed = 0;    ///< of a key: the character that it prints with its modifiers, 0 where that is none
};

class KeyQueue {
  public:
    bool is_empty() const { return waiting_.empty(); }

    /// Adds an event at the end. A key that repeats while it waits is one repeat, so that slow frames do not lag
    /// behind.
    void push(const KeyEvent& event);

    /// The key that was added last prints `character`.
    void note_printed(unsigned character);

    /// Takes the events of the coming frame off the front: up to where a key changes for the second time, a modifier
    /// changes after a key that it would be mistaken to have been held for, or anything is typed after a key that acts
    /// on what was typed before.
    std::vector<KeyEvent> take_portion();

  private:
    std::deque<KeyEvent> waiting_;
};

}  // namespace batten::platform
