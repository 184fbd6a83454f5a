/// Findings as they are printed, for people and as JSON.
#pragma once

#include <iosfwd>

#include "app/cli/json_output.h"
#include "app/editor/state/findings.h"

namespace batten::cli {

/// One indented line with tabs between its parts.
void print(std::ostream& out, const editor::Finding& finding);

Json json_of(const editor::Finding& finding);

}  // namespace batten::cli
