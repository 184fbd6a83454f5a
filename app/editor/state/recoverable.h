/// A document that a session left unsaved, as the next one offers it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/document/file_stamp.h"

namespace batten::editor {

class HeldJournal;

struct Recoverable {
    std::filesystem::path journal;         ///< the file that has it
    std::filesystem::path file;            ///< that the document belongs to; empty for one without a file
    std::optional<core::FileStamp> stamp;  ///< of that file when it was read or written
    std::int64_t seconds = 0;              ///< when it was edited last, since 1970
    std::size_t edit_count = 0;            ///< since it was saved, or begun
    std::shared_ptr<HeldJournal> held{};   ///< keeps other sessions from it
};

}  // namespace batten::editor
