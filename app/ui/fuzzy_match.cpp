#include "app/ui/fuzzy_match.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

#include "core/base/ascii.h"

namespace batten::ui {

namespace {

constexpr int impossible = std::numeric_limits<int>::min() / 2;
constexpr int hit = 1;
constexpr int run_bonus = 4;
constexpr int word_bonus = 6;
constexpr int begin_bonus = 4;

/// Small letters without accents; of those beyond ASCII only the ones that the program writes.
std::string folded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool is_e_acute = text.substr(i, 2) == "é" || text.substr(i, 2) == "É";
        result += is_e_acute ? 'e' : core::small_letter(text[i]);
        if (is_e_acute) ++i;
    }
    return result;
}

bool is_between_words(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) == 0 && static_cast<unsigned char>(c) < 0x80;
}

bool begins_word(std::string_view text, std::size_t i) {
    return i == 0 || is_between_words(text[i - 1]);
}

int hit_score(std::string_view text, std::size_t i) {
    return hit + (begins_word(text, i) ? word_bonus : 0) + (i == 0 ? begin_bonus : 0);
}

/// The score of a run of letters that begins a word.
int run_score(std::size_t length) {
    return static_cast<int>(length) * hit + (static_cast<int>(length) - 1) * run_bonus + word_bonus;
}

std::optional<int> score_of_folded(const std::string& pattern, const std::string& text) {
    // ending[i]: the best score of the letters so far with the last of them at text[i].
    std::vector<int> ending(text.size(), 0);
    bool is_first = true;
    for (const char letter : pattern) {
        if (letter == ' ') continue;
        std::vector<int> next(text.size(), impossible);
        int best_before = is_first ? 0 : impossible;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const int in_run = !is_first && i > 0 ? ending[i - 1] + run_bonus : impossible;
            const int before = std::max(best_before, in_run);
            if (text[i] == letter && before > impossible / 2) next[i] = before + hit_score(text, i);
            if (!is_first) best_before = std::max(best_before, ending[i]);
        }
        ending = std::move(next);
        is_first = false;
    }
    if (is_first) return 0;
    const auto best = std::max_element(ending.begin(), ending.end());
    if (best == ending.end() || *best <= impossible / 2) return std::nullopt;
    return *best;
}

bool has_word_beginning(std::string_view text, std::string_view word) {
    for (std::size_t i = text.find(word); i != std::string_view::npos; i = text.find(word, i + 1))
        if (begins_word(text, i)) return true;
    return false;
}

}  // namespace

std::optional<int> fuzzy_score(std::string_view pattern, std::string_view text) {
    return score_of_folded(folded(pattern), folded(text));
}

std::optional<int> word_score(std::string_view pattern, std::string_view text) {
    const std::string within = folded(text);
    const std::string words = folded(pattern);
    int score = 0;
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find(' ', begin), words.size());
        const std::string_view word = std::string_view(words).substr(begin, end - begin);
        begin = end + 1;
        if (word.empty()) continue;
        if (!has_word_beginning(within, word)) return std::nullopt;
        score += run_score(word.size());
    }
    return score;
}

Beginning beginning_of(std::string_view pattern, std::string_view text) {
    const std::string begin = folded(pattern);
    const std::string whole = folded(text);
    if (begin.empty() || !whole.starts_with(begin)) return Beginning::none;
    return whole.size() == begin.size() ? Beginning::whole : Beginning::prefix;
}

}  // namespace batten::ui
