/// Gathers what there is to tell of a file, in a bounded number of sentences.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/sentence.h"

namespace batten::exchange {

/// Where something stands ("line 12"), or what it is called. Asked only where it is told, which of many things are few.
using PlaceText = std::function<std::string()>;

class Notes {
  public:
    /// Notes that `pattern` holds of `what` at `place`. Each pattern, `what` and `reason` make one sentence, which has
    /// the places {what}, {reason}, {count}, and {place} of the first.
    void add(const core::PluralPattern& pattern, const PlaceText& place, std::string_view what = {},
             std::string_view reason = {});

    /// Notes a whole sentence.
    void add(const char* sentence) {
        add(core::PluralPattern{sentence, sentence}, [] { return std::string(); });
    }

    /// In the order in which they were noted first. Beyond forty of them, one says how many more things there were.
    std::vector<std::string> sentences() const;

  private:
    struct Note {
        core::PluralPattern pattern;
        std::string what;
        std::string place;
        std::string reason;
        std::size_t count = 1;
    };
    using Key = std::tuple<const char*, std::string, std::string>;

    std::vector<Note> notes_;
    std::map<Key, std::size_t> indices_;
    std::size_t further_ = 0;  // for which there was no room
};

}  // namespace batten::exchange
