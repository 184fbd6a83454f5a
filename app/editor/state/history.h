/// Undo as a list of older documents.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/state/same_document.h"
#include "core/document/document.h"

namespace batten::editor {

/// What undo may keep: 512 MB, some thirty steps that move all of a million control points.
inline constexpr std::size_t most_history_bytes = std::size_t{512} << 20U;

/// The documents before and after each step, and where we stand. Curves and their arrays are shared, so a step costs
/// what it changed. The oldest steps are forgotten where all of them hold more than `most_bytes`, but never the last
/// one.
class History {
  public:
    explicit History(core::Document start = {}, std::size_t most_bytes = most_history_bytes);

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
    void amend(core::Document document);

    void mark_saved();
    /// What the history begins with is in no file.
    void mark_unsaved();

    /// Whether the present document is the one that was saved last, or that the history began with, or is like it.
    bool is_saved() const { return is_saved_; }

    /// The same as long as the present document is; keep it to see whether it still is.
    std::shared_ptr<const void> version() const { return version_; }

    std::size_t undo_count() const { return position_; }
    std::size_t redo_count() const { return steps_.size() - 1 - position_; }

    /// What all documents hold together in curves: each array once for the first of consecutive documents that share
    /// it.
    std::size_t byte_count() const { return byte_count_; }

  private:
    struct Step {
        std::string label;
        core::Document document;
        std::size_t byte_count = 0;  ///< of what the document before does not hold
    };

    const core::Document* document_before(std::size_t step) const;
    void count_bytes(std::size_t step);
    void forget_oldest();
    void go_to(std::size_t position);

    std::vector<Step> steps_;
    std::size_t position_ = 0;
    std::optional<core::Document> saved_;
    bool is_saved_ = true;
    std::shared_ptr<const void> version_;
    std::size_t byte_count_ = 0;
    std::size_t most_bytes_;
};

}  // namespace batten::editor
