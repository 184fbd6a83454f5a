/// Keeps what was computed for a value as long as it is asked for, so that it is computed once.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace batten::editor {

/// For immutable keys that share their contents: is_shared(a, b) says, at once, whether two of them are the same. Holds
/// on to the few keys that were asked for last.
template <class Key, class Value, bool (*is_shared)(const Key&, const Key&)>
class Kept {
  public:
    /// The value that `compute(key)` gives, or gave.
    template <class Compute>
    std::shared_ptr<const Value> of(const Key& key, const Compute& compute) const {
        const auto found =
            std::ranges::find_if(entries_, [&](const Entry& entry) { return is_shared(entry.key, key); });
        if (found != entries_.end()) {
            std::rotate(entries_.begin(), found, std::next(found));
        } else {
            if (entries_.size() == most_entries) entries_.pop_back();
            entries_.insert(entries_.begin(), {key, std::make_shared<const Value>(compute(key))});
        }
        return entries_.front().value;
    }

  private:
    static constexpr std::size_t most_entries = 3;  // what is committed, what is shown, and what is about to be

    struct Entry {
        Key key;
        std::shared_ptr<const Value> value;
    };
    mutable std::vector<Entry> entries_;  // the one asked for last comes first
};

}  // namespace batten::editor
