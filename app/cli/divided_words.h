/// Divides what stands behind `apply` and `new` into options and operations: what an operation needs may look like an
/// option, and -- may stand between two operations.
#pragma once

#include <string>
#include <vector>

namespace batten::cli {

struct DividedWords {
    std::vector<std::string> options;     ///< with the file, where there is one
    std::vector<std::string> operations;  ///< with their arguments, and each "--" among them
};

/// Options are words that begin with "--", "-o" or "-h", other than "--" itself, where no argument of an operation is
/// needed; the name of an option as it stands ("-o") is one even there, but behind "--". The first word that is none,
/// or stands behind "--", is a file where `has_file`.
DividedWords divided(const std::vector<std::string>& words, bool has_file);

}  // namespace batten::cli
