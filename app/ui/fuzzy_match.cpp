#include "app/ui/fuzzy_match.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

namespace batten::ui {

namespace {

constexpr int impossible = std::numeric_limits<int>::min() / 2;
constexpr int hit = 1;
constexpr int run_bonus = 4;
constexpr int word_bonus = 6;
constexpr int begin_bonus = 4;

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool begins_word(const std::string& text, std::size_t i) {
    return i == 0 || text[i - 1] == ' ' || text[i - 1] == '-';
}

int hit_score(const std::string& text, std::size_t i) {
    return hit + (begins_word(text, i) ? word_bonus : 0) + (i == 0 ? begin_bonus : 0);
}

}  // namespace

std::optional<int> fuzzy_score(const std::string& pattern, const std::string& text) {
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
            if (lower(text[i]) == lower(letter) && before > impossible / 2) next[i] = before + hit_score(text, i);
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

}  // namespace batten::ui
