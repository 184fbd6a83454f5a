#include "app/editor/state/history.h"

#include <iterator>

#include "app/editor/state/document_bytes.h"

namespace batten::editor {

namespace {

const std::string no_label;

}  // namespace

History::History(core::Document start, std::size_t most_bytes) : saved_(start), most_bytes_(most_bytes) {
    steps_.push_back({{}, std::move(start)});
    count_bytes(0);
    go_to(0);
}

const std::string& History::undo_label() const {
    return can_undo() ? steps_[position_].label : no_label;
}

const std::string& History::redo_label() const {
    return can_redo() ? steps_[position_ + 1].label : no_label;
}

void History::push(std::string label, core::Document document) {
    for (; steps_.size() > position_ + 1; steps_.pop_back()) byte_count_ -= steps_.back().byte_count;
    steps_.push_back({std::move(label), std::move(document)});
    count_bytes(position_ + 1);
    go_to(position_ + 1);
    while (byte_count_ > most_bytes_ && position_ > 1) forget_oldest();
}

void History::extend(std::string label, core::Document document) {
    --position_;
    push(std::move(label), std::move(document));
}

void History::undo() {
    if (can_undo()) go_to(position_ - 1);
}

void History::redo() {
    if (can_redo()) go_to(position_ + 1);
}

void History::amend(core::Document document) {
    steps_[position_].document = std::move(document);
    count_bytes(position_);
    if (can_redo()) count_bytes(position_ + 1);
    go_to(position_);
}

void History::mark_saved() {
    saved_ = present();
    go_to(position_);
}

void History::mark_unsaved() {
    saved_.reset();
    go_to(position_);
}

const core::Document* History::document_before(std::size_t step) const {
    return step == 0 ? nullptr : &steps_[step - 1].document;
}

void History::count_bytes(std::size_t step) {
    Step& counted = steps_[step];
    byte_count_ -= counted.byte_count;
    counted.byte_count = bytes_beside(counted.document, document_before(step));
    byte_count_ += counted.byte_count;
}

void History::forget_oldest() {
    byte_count_ -= steps_.front().byte_count;
    steps_.erase(steps_.begin());
    --position_;
    count_bytes(0);
}

// Comparing documents once for a change, and not whenever it is asked for.
void History::go_to(std::size_t position) {
    position_ = position;
    is_saved_ = saved_ && has_same_content(*saved_, present());
    version_ = std::make_shared<const char>();
}

}  // namespace batten::editor
