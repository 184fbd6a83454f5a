/// What of `--show` a figure would look the same without.
#pragma once

#include <string>
#include <vector>

#include "app/cli/subcommands.h"
#include "core/document/document.h"

namespace batten::cli {

/// The words of `options.show`, as they were typed, each of which changes nothing of a figure of `document`, or of what
/// that has no room for, and of its first, middle and last frame where something moves. Without words none. The options
/// can be read, and the curve moves as they ask. Cost: those pictures once for all words and once for each.
std::vector<std::string> idle_words(const FigureOptions& options, const core::Document& document);

/// A sentence about them; they are not none.
std::string note_on_idle_words(const std::vector<std::string>& words);

}  // namespace batten::cli
