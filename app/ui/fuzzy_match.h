/// Finds what somebody means who types a few letters of a name.
#pragma once

#include <optional>
#include <string>

namespace batten::ui {

/// How well `text` fits the letters of `pattern`, which must all occur in it in order, whatever their case; none where
/// they do not. Higher is better: letters in one run and at the beginnings of words count more. An empty pattern fits
/// anything equally. ASCII letters only are compared without case. Cost: pattern times text.
std::optional<int> fuzzy_score(const std::string& pattern, const std::string& text);

}  // namespace batten::ui
