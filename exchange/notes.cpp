#include "exchange/notes.h"

#include "exchange/utf8_text.h"

namespace batten::exchange {

namespace {

constexpr std::size_t most_notes = 40;

std::string quotation(std::string_view text) {
    constexpr std::size_t longest = 40;
    return utf8_text(text.substr(0, longest));
}

}  // namespace

void Notes::add(const core::PluralPattern& pattern, const PlaceText& place, std::string_view what,
                std::string_view reason) {
    const Key key{pattern.one, quotation(what), reason};
    const auto found = indices_.find(key);
    if (found != indices_.end()) {
        ++notes_[found->second].count;
        return;
    }
    if (notes_.size() == most_notes) {
        ++further_;
        return;
    }
    indices_[key] = notes_.size();
    notes_.push_back({pattern, std::get<1>(key), utf8_text(place()), std::get<2>(key)});
}

std::vector<std::string> Notes::sentences() const {
    std::vector<std::string> sentences;
    for (const Note& note : notes_)
        sentences.push_back(core::filled_as_needed(
            note.pattern.for_count(note.count),
            {{"what", note.what}, {"place", note.place}, {"reason", note.reason}, {"count", note.count}}));
    if (further_ > 0)
        sentences.push_back(core::sentence({.one = "there is one more thing to tell, of another kind",
                                            .many = "there are {count} more things to tell, of other kinds"},
                                           further_));
    return sentences;
}

}  // namespace batten::exchange
