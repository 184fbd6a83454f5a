/// Undo as a list of older documents.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/editor/same_document.h"
#include "core/document/document.h"

namespace batten::editor {

/// The documents before and after each step, and where we stand. Curves are shared, so a step costs a few pointers.
class History {
  public:
    explicit History(core::Document start = {});

    const core::Document& present() const { return steps_[position_].document; }
    /// The document that undo would bring back; there must be one.
    const core::Document& previous() const { return steps_[position_ - 1].document; }

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ + 1 < steps_.size(); }

    /// The label of the step that undo would take back or redo would repeat; empty if there is none.
    const std::string& undo_label() const;
    const std::string& redo_label() const;

    /// Adds `document` as the present and forgets what was undone.
    void push(std::string label, core::Document document);
    /// Replaces the present, which can be undone, by `document`, as what the same step led to.
    void extend(std::string label, core::Document document);

    void undo();
    void redo();

    /// Changes what is not undone (active curve) in the present document.
    void amend(core::Document document) { steps_[position_].document = std::move(document); }

    void mark_saved() { saved_ = present(); }

    /// Whether the present document is the one that was saved last, or that the history began with, or is like it.
    bool is_saved() const { return has_same_content(saved_, present()); }

    std::size_t undo_count() const { return position_; }
    std::size_t redo_count() const { return steps_.size() - 1 - position_; }

  private:
    struct Step {
        std::string label;
        core::Document document;
    };
    std::vector<Step> steps_;
    std::size_t position_ = 0;
    core::Document saved_;
};

}  // namespace batten::editor
