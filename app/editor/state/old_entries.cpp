#include "app/editor/state/old_entries.h"

#include <map>

namespace batten::editor {

namespace {

// The curves of a document by what they are and by what they are called, the first ones.
class EntriesFound {
  public:
    explicit EntriesFound(const core::Document& document) {
        for (const core::DocumentCurve& entry : document.curves) {
            by_curve_.emplace(entry.curve.get(), &entry);
            by_name_.emplace(entry.name, &entry);
        }
    }

    const core::DocumentCurve* find(const core::DocumentCurve& wanted) const {
        if (const auto found = by_curve_.find(wanted.curve.get()); found != by_curve_.end()) return found->second;
        const auto found = by_name_.find(wanted.name);
        return found == by_name_.end() ? nullptr : found->second;
    }

  private:
    std::map<const core::Curve*, const core::DocumentCurve*> by_curve_;
    std::map<std::string_view, const core::DocumentCurve*> by_name_;
};

}  // namespace

std::vector<const core::DocumentCurve*> old_entries(const core::Document& before, const core::Document& after) {
    std::optional<EntriesFound> others;
    std::vector<const core::DocumentCurve*> old;
    old.reserve(after.curves.size());
    for (std::size_t i = 0; i < after.curves.size(); ++i) {
        const bool is_in_place =
            before.curves.size() == after.curves.size() && before.curves[i].name == after.curves[i].name;
        if (!is_in_place && !others) others.emplace(before);
        old.push_back(is_in_place ? &before.curves[i] : others->find(after.curves[i]));
    }
    return old;
}

}  // namespace batten::editor
