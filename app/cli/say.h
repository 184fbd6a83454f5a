/// Sentences on standard error.
#pragma once

#include <string>

#include "app/cli/subcommands.h"

namespace batten::cli {

/// Writes `sentence` as one line, whatever words of the command line or names of files it has: what is not printed, or
/// not UTF-8, becomes a question mark.
void say(Output output, const std::string& sentence);

/// The same for a command line that is wrong; returns that.
ExitStatus say_wrong_usage(Output output, const std::string& sentence);

/// `text` as it is printed by say().
std::string printable(const std::string& text);

}  // namespace batten::cli
