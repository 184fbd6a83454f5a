#include "app/editor/recovery/journal_keeper.h"

#include <utility>

#include "app/editor/state/same_document.h"

namespace batten::editor {

JournalKeeper::JournalKeeper(const std::filesystem::path& folder, std::function<void()> wake,
                             std::chrono::milliseconds pause) {
    if (!folder.empty()) writer_ = std::make_unique<JournalWriter>(folder, std::move(wake), pause);
}

// What was recovered has the edits of the session before.
void JournalKeeper::count_edit(const EditorState& state) {
    const History& history = state.history;
    if (state.recovered && history.undo_count() + history.redo_count() == 0)
        edit_count_ = state.recovered->edit_count;
    else if (!is_journaled_ || !has_same_content(last_, history.present()))
        ++edit_count_;
}

void JournalKeeper::follow(const EditorState& state, std::int64_t seconds) {
    if (version_ == state.history.version()) return;
    version_ = state.history.version();
    if (writer_ == nullptr) return note_lack_of_folder(state);
    if (state.is_modified()) {
        count_edit(state);
        last_ = state.history.present();
        writer_->write({last_,
                        {state.path, state.stamp, seconds, edit_count_},
                        state.recovered ? state.recovered->held : nullptr});
    } else {
        if (is_journaled_) writer_->clear();
        last_ = {};
        edit_count_ = 0;
    }
    is_journaled_ = state.is_modified();
}

// Once until nothing is unsaved any more, like other trouble.
void JournalKeeper::note_lack_of_folder(const EditorState& state) {
    const bool is_first = state.is_modified() && !std::exchange(is_journaled_, state.is_modified());
    if (is_first)
        lack_of_folder_ =
            "Unsaved changes would be lost in a crash, because no recovery journal can be written: neither HOME nor "
            "XDG_STATE_HOME names a folder";
}

void JournalKeeper::finish() {
    if (writer_ != nullptr) writer_->finish();
}

void JournalKeeper::end() {
    if (writer_ != nullptr && is_journaled_) writer_->clear();
}

std::optional<std::string> JournalKeeper::take_trouble() {
    return writer_ == nullptr ? std::exchange(lack_of_folder_, std::nullopt) : writer_->take_trouble();
}

}  // namespace batten::editor
