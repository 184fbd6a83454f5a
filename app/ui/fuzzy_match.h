/// Finds what somebody means who types a few letters of a name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace batten::ui {

/// How well `text` fits the letters of `pattern`, which must all occur in it in order, whatever their case and accents;
/// none where they do not. Higher is better: letters in one run and at the beginnings of words count more. An empty
/// pattern fits anything equally. Cost: pattern times text.
std::optional<int> fuzzy_score(std::string_view pattern, std::string_view text);

/// The same, but every word of `pattern` must be the beginning of a word of `text`: for long texts, in which scattered
/// letters mean nothing.
std::optional<int> word_score(std::string_view pattern, std::string_view text);

/// How much of `text` somebody typed who typed `pattern`, whatever its case and accents: all of it, its beginning, or
/// neither. An empty pattern is neither.
enum class Beginning { none, prefix, whole };
Beginning beginning_of(std::string_view pattern, std::string_view text);

}  // namespace batten::ui
