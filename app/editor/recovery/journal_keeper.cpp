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
    if (writer_ == nullptr || version_ == state.history.version()) return;
    version_ = state.history.version();
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

void JournalKeeper::finish() {
    if (writer_ != nullptr) writer_->finish();
}

void JournalKeeper::end() {
    if (writer_ != nullptr && is_journaled_) writer_->clear();
}

std::optional<std::string> JournalKeeper::take_trouble() {
    return writer_ == nullptr ? std::nullopt : writer_->take_trouble();
}

}  // namespace batten::editor
