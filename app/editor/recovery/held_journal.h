/// The file of a recovery journal, which only one session at a time has.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/editor/fields/field.h"

namespace batten::editor {

/// A file with a lock that ends with the process, however that ends. The refusals are what the system says.
class HeldJournal {
  public:
    /// The journal at `path`; null where another session has it, or it cannot be opened.
    static std::shared_ptr<HeldJournal> take(const std::filesystem::path& path);

    /// A journal that is to be at `path`, where no file is yet; replace() makes it.
    explicit HeldJournal(std::filesystem::path path);
    ~HeldJournal();
    HeldJournal(const HeldJournal&) = delete;
    HeldJournal& operator=(const HeldJournal&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Whether the file is there: it was made, and nobody removed it.
    bool is_there() const;

    /// Whether nobody cut it off either.
    bool is_whole() const;

    std::int64_t size() const { return size_; }

    /// At most `count` bytes from `place` on; fewer where it ends before.
    [[nodiscard]] Outcome<std::string> part(std::int64_t place, std::size_t count) const;

    /// All that is in it.
    [[nodiscard]] Outcome<std::string> content() const { return part(0, static_cast<std::size_t>(size_)); }

    /// Puts `content` in place of all that is in it, at once: after a crash the old content is there or the new one.
    [[nodiscard]] Outcome<void> replace(std::string_view content);

    /// Adds `record` at the end; it is on disk then. What was refused leaves nothing behind.
    [[nodiscard]] Outcome<void> append(std::string_view record);

    /// Removes the file.
    void remove();

  private:
    std::filesystem::path path_;
    int file_ = -1;
    std::int64_t size_ = 0;
};

}  // namespace batten::editor
