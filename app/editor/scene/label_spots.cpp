#include "app/editor/scene/label_spots.h"

namespace batten::editor {

namespace {

/// "C(0.25)" as "C()"; indices, which stand in braces, stay: "P_{3}".
std::string without_values(std::string_view text) {
    std::string rest;
    bool is_index = false;
    for (const char c : text) {
        if (c == '{' || c == '}') is_index = c == '{';
        const bool is_of_value = ('0' <= c && c <= '9') || c == '.' || c == '/';
        if (is_index || !is_of_value) rest.push_back(c);
    }
    return rest;
}

}  // namespace

LabelSpots::Key LabelSpots::next(std::string_view text) {
    std::string name = without_values(text);
    const std::size_t count = counts_[name]++;
    return {std::move(name), count};
}

std::optional<LabelSpot> LabelSpots::spot(const Key& key) const {
    const auto found = spots_.find(key);
    return found == spots_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace batten::editor
