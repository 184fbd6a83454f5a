/// The editor without a window: holds the state and is the only one to write it.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/settings.h"
#include "app/editor/state/state.h"

namespace batten::editor {

class Editor {
  public:
    explicit Editor(Desktop desktop = {});

    /// The editor with `document` open, which belongs to no file.
    explicit Editor(core::Document document);

    ~Editor();
    Editor(Editor&& other) noexcept;
    Editor& operator=(Editor&& other) noexcept;

    /// Looks at the document as `settings` remember, at the start.
    void apply(const Settings& settings);

    const EditorState& state() const { return state_; }

    /// Runs a command. A refused command changes nothing but the message; only the preview of an edit goes with every
    /// further edit. A commit of an edit becomes one step of the history, unless it changes nothing, and shows the
    /// older shape as a ghost where the command changes it. The preview of an act does nothing but take back an earlier
    /// refusal. Returns whether the command did what it was asked for.
    ///
    /// Where the desktop can be woken, a commit that takes longer than a moment goes on beside the interface, as
    /// state().at_work tells, and its outcome comes with follow_work(); so do those of commits that are asked for
    /// meanwhile, in order. Quit stops what is at work. False is returned for both.
    bool run(const Command& command, Phase phase = Phase::commit);

    /// Drops the preview.
    void cancel_preview();

    /// Tells in the state how far the command at work is, and takes its outcome once it is finished. Returns whether
    /// anything changed. To be called for each frame.
    bool follow_work();

    /// Stops the command at work as soon as it can be; it then has done nothing.
    void cancel_work();

    /// Changes what is neither undone nor logged.
    void change(const ViewChange& change);

    /// Does what is asked for; all of a queue in order.
    void perform(const Request& request);
    void perform(CommandQueue& queue);

    /// The logged commands committed so far, in order: running them again from the same start gives the same document.
    const std::vector<Command>& log() const { return log_; }

  private:
    bool run_here(const Command& command, Phase phase);
    bool begin_work(const Command& command);
    bool finish_work();
    void note(const Command& command);

    EditorState state_;
    std::vector<Command> log_;

    // The command that works beside the interface.
    struct AtWorkNow;
    std::unique_ptr<AtWorkNow> at_work_;
};

}  // namespace batten::editor
