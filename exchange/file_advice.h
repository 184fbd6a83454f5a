/// What to do with a file that is none of those that were expected.
#pragma once

#include <filesystem>
#include <optional>

#include "exchange/format.h"

namespace batten::exchange {

/// Why the file at `path` is none of Batten's own, or none of the format `read`, with advice where its first bytes
/// look like another kind of file: one whose format has to be chosen, since its ending does not say it, one of Batten's
/// own, where another format was expected, or one that is not read as curves at all, as a font, a picture, a
/// spreadsheet or a compressed drawing. `error` without advice where they look like none. A JSON text of up to 4 MiB
/// may be read whole.
core::FileError with_advice(core::FileError error, const std::filesystem::path& path,
                            std::optional<Format> read = std::nullopt);

}  // namespace batten::exchange
