#include "app/editor/words/blossom_text.h"

#include <fmt/format.h>

#include <vector>

namespace batten::editor {

namespace {

constexpr std::size_t most_arguments = 6;

/// Up to two arguments, or the first and the last of more.
void add_shortened(std::vector<std::string>& words, const std::vector<std::string>& arguments) {
    if (arguments.size() <= 2) {
        words.insert(words.end(), arguments.begin(), arguments.end());
        return;
    }
    words.insert(words.end(), {arguments.front(), "…", arguments.back()});
}

template <class WordOf>
std::string label_with(const core::BlossomLabel& label, WordOf word_of) {
    std::vector<std::string> knots;
    for (std::size_t k = 0; k < label.knots.size(); ++k) knots.push_back(word_of(k));
    const std::vector<std::string> parameters(label.parameter_count, "u");
    std::vector<std::string> words;
    if (knots.size() + parameters.size() > most_arguments) {
        add_shortened(words, knots);
        add_shortened(words, parameters);
    } else {
        words = std::move(knots);
        words.insert(words.end(), parameters.begin(), parameters.end());
    }
    return fmt::format("f({})", fmt::join(words, ", "));
}

}  // namespace

std::string blossom_by_indices(const core::BlossomLabel& label) {
    return label_with(label, [&](std::size_t k) { return fmt::format("u_{{{}}}", label.first_knot + k); });
}

std::string blossom_by_values(const core::BlossomLabel& label, const Notation& notation) {
    return label_with(label, [&](std::size_t k) { return exact_text(notation, label.knots[k]); });
}

}  // namespace batten::editor
