/// One command that takes long, at work beside the interface.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "app/editor/command.h"
#include "app/editor/fields/field.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// What the work led to.
struct WorkResult {
    EditorState state;
    bool is_done;  ///< false where the command was refused, as the state's message says
};

/// Runs a command on a copy of the state, in a thread of its own, so that the state itself stays as it is until the
/// result takes its place. The copy has no clipboard of the desktop.
class Work {
  public:
    /// `run` does what the command asks for to the state that it is given and returns whether it did. `wake` is called
    /// from the thread whenever share() has changed visibly, and at the end.
    Work(const EditorState& state, std::function<bool(EditorState&)> run, std::function<void()> wake);

    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    /// How much is done, from 0 to 1; none where nothing was told yet.
    std::optional<double> share() const;

    /// What is read so far of the file that is being opened.
    Sketch sketch() const;

    /// Asks the work to stop. It does so when it next tells how far it is, and its result is given up; what has told
    /// that all is done goes on to its end.
    void cancel();
    bool is_canceled() const { return is_canceled_; }

    bool is_finished() const { return wait_for(std::chrono::milliseconds(0)); }

    /// Waits at most so long; returns whether the work is finished then.
    bool wait_for(std::chrono::milliseconds time) const;

    /// The result of work that is finished, once. The refusal says that it was canceled, or lacked memory.
    Outcome<WorkResult> take();

  private:
    struct Shared;

    std::shared_ptr<Shared> shared_;
    bool is_canceled_ = false;
    std::jthread thread_;
};

/// Whether the command, or the document that it works on, is so large that it may take long.
bool is_large(const EditorState& state, const Command& command);

}  // namespace batten::editor
