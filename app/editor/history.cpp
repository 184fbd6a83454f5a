#include "app/editor/history.h"

#include <iterator>

namespace batten::editor {

namespace {

const std::string no_label;

}  // namespace

History::History(core::Document start) {
    saved_ = start;
    steps_.push_back({{}, std::move(start)});
}

const std::string& History::undo_label() const {
    return can_undo() ? steps_[position_].label : no_label;
}

const std::string& History::redo_label() const {
    return can_redo() ? steps_[position_ + 1].label : no_label;
}

void History::push(std::string label, core::Document document) {
    steps_.erase(std::next(steps_.begin(), static_cast<std::ptrdiff_t>(position_ + 1)), steps_.end());
    steps_.push_back({std::move(label), std::move(document)});
    ++position_;
}

void History::extend(std::string label, core::Document document) {
    --position_;
    push(std::move(label), std::move(document));
}

void History::undo() {
    if (can_undo()) --position_;
}

void History::redo() {
    if (can_redo()) ++position_;
}

}  // namespace batten::editor
