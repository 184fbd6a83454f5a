/// What is said where no curve has the name or number that was given.
#pragma once

#include <string>

#include "core/document/document.h"

namespace batten::editor {

/// "there is no curve 'wav'; did you mean 'wave'?", else with the curves that there are, the first ten of many, and
/// their numbers.
std::string unknown_curve(const core::Document& document, const std::string& name);

}  // namespace batten::editor
