/// The options of `batten figure` on the command line.
#pragma once

#include "app/cli/subcommands.h"

namespace CLI {
class App;
}

namespace batten::cli {

/// Adds them to `command`, which is parsed into `options`; both live as long as they are used.
void add_figure_words(CLI::App& command, FigureOptions& options);

}  // namespace batten::cli
