/// Has the journal follow the editor.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/recovery/journal_writer.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// Of each document that is committed and not saved a record is written; where nothing is unsaved there is no journal.
class JournalKeeper {
  public:
    /// Journals stand in `folder`; where it is empty none is kept, which is trouble to tell. `wake` is called from
    /// another thread when there is trouble to tell.
    explicit JournalKeeper(const std::filesystem::path& folder, std::function<void()> wake = {},
                           std::chrono::milliseconds pause = usual_pause);

    /// Hands over the document where it is another than the last time. To be called after commands, at `seconds` since
    /// 1970. Costs a copy of the document, which shares its curves.
    void follow(const EditorState& state, std::int64_t seconds);

    /// Waits until all of it is on disk.
    void finish();

    /// The session ends as it should: what is not saved was given up.
    void end();

    /// Why the journal could not be written, as a whole sentence, once.
    std::optional<std::string> take_trouble();

  private:
    void count_edit(const EditorState& state);
    void note_lack_of_folder(const EditorState& state);

    std::unique_ptr<JournalWriter> writer_;  // null: none is kept
    std::shared_ptr<const void> version_;    // of the document that was handed over last
    core::Document last_;
    std::size_t edit_count_ = 0;
    bool is_journaled_ = false;
    std::optional<std::string> lack_of_folder_;
};

}  // namespace batten::editor
