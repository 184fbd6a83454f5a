/// Where a text can be ended early and still says something whole.
#pragma once

#include <string>
#include <vector>

namespace batten::editor {

/// The beginnings of `text` that end where a sentence, a clause or one of several hints (" · ") does, or before an
/// aside in parentheses, the longest first, each with " …" for what is left out; never the whole text. What is in
/// parentheses or braces is not cut.
std::vector<std::string> shorter_beginnings(const std::string& text);

}  // namespace batten::editor
