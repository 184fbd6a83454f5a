/// Keeps what was computed for a value, so that it is computed once.
#pragma once

#include <algorithm>
#include <memory>
#include <unordered_map>
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

/// For any number of keys, what is computed for each as long as somebody else holds the key.
template <class Key, class Value>
class KeptBeside {
  public:
    /// The value that `compute(*key)` gives, or gave.
    template <class Compute>
    std::shared_ptr<const Value> of(const std::shared_ptr<const Key>& key, const Compute& compute) const {
        Entry& entry = entries_[key.get()];
        // Another key may stand where one stood that is gone.
        if (entry.key.lock() == key) return entry.value;
        entry = {key, std::make_shared<const Value>(compute(*key))};
        std::shared_ptr<const Value> value = entry.value;
        if (entries_.size() > most_entries_) forget_the_gone();
        return value;
    }

    std::size_t size() const { return entries_.size(); }

  private:
    struct Entry {
        std::weak_ptr<const Key> key;
        std::shared_ptr<const Value> value;
    };

    void forget_the_gone() const {
        std::erase_if(entries_, [](const auto& entry) { return entry.second.key.expired(); });
        most_entries_ = 2 * entries_.size() + 2;
    }

    mutable std::unordered_map<const Key*, Entry> entries_;
    mutable std::size_t most_entries_ = 2;
};

}  // namespace batten::editor
