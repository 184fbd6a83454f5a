/// What stands in the file of a journal: a head, then one record for each document that was committed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/editor/state/recoverable.h"

namespace batten::editor {

/// What a record tells beside the document.
struct JournalFacts {
    std::filesystem::path file;            ///< that the document belongs to; empty for one without a file
    std::optional<core::FileStamp> stamp;  ///< of that file when it was read or written
    std::int64_t seconds = 0;              ///< when it was edited last, since 1970
    std::size_t edit_count = 0;            ///< since it was saved, or begun
};

struct JournalRecord {
    JournalFacts facts;
    std::string_view delta;  ///< from the document before; in the text of the journal
};

/// The head of a journal. It tells the version of the format, and the machine's order of bytes.
std::string_view journal_head();

/// Of a record, before which so many bytes stand.
inline constexpr std::size_t record_head_bytes = 16;

/// How many bytes come after the first record_head_bytes of a record; 0 where they begin none.
std::uint64_t record_bytes(std::string_view record_head);

/// Writes the records of one journal, each with a checksum of all before it.
class RecordWriter {
  public:
    /// The bytes of the next record.
    std::string written(const JournalFacts& facts, std::string_view delta);

    /// The record written last came to nothing and is not part of the journal.
    void take_back() { checksum_ = checksum_before_; }

  private:
    std::uint64_t checksum_ = 0;
    std::uint64_t checksum_before_ = 0;
};

/// Reads the records of a journal, as long as they are whole and nothing in them or before them has changed.
class RecordReader {
  public:
    /// `journal` must outlive the reader.
    explicit RecordReader(std::string_view journal);

    /// The next record; none where no further one is whole, or the head is of another version or machine.
    std::optional<JournalRecord> next();

    /// Whether the head is one that this program writes.
    bool is_known() const { return is_known_; }

  private:
    std::string_view left_;
    std::uint64_t checksum_ = 0;
    bool is_known_;
};

}  // namespace batten::editor
