/// What is checked of every JSON text while it is read, whatever is made of it.
#pragma once

#include <set>

#include "core/document/detail/native_format.h"
#include "core/document/detail/text_stream.h"

namespace batten::core {

/// Lists and objects inside one another beyond this are refused, because trees are walked by recursion.
inline constexpr std::size_t deepest_nesting = 100;

/// Objects of more members are refused, because one is found by comparing with all.
inline constexpr std::size_t most_members = 10'000;

/// Notes the first defect of a text and its place, for a class that is told by the library what the text says.
class JsonChecks : public nlohmann::json_sax<Json> {
  public:
    explicit JsonChecks(TextStream& text) : text_(text) {}

    /// Reads the text, of which no more than `most_bytes` may pass through the library. Errors: anything that is not
    /// JSON, numbers too large for a double, text that is not UTF-8, nesting and members beyond the limits, a member
    /// that occurs twice in one object, each with "line L, column C"; what was refused; what ended the text early.
    [[nodiscard]] FileResult<void> read(std::size_t most_bytes);

    bool parse_error(std::size_t byte, const std::string& token, const nlohmann::detail::exception& exception) final;
    bool binary(binary_t& /*value*/) final { return false; }

  protected:
    /// Whether there is room for a list or an object inside the ones that are open.
    bool enter();
    void leave() { names_.pop_back(); }

    /// Whether the innermost object may have a member of this name.
    bool add_name(const std::string& name);

    /// Ends reading with `what`, at what was read last; false.
    bool refuse_here(std::string what);

    /// Says that so many bytes were taken from the text past the library.
    void note_taken(std::size_t bytes) { bytes_taken_ += bytes; }

  private:
    bool refuse(FileError error);

    TextStream& text_;
    std::vector<std::set<std::string>> names_;  // of the members of each list or object that is open
    std::size_t bytes_taken_ = 0;
    FileError error_;
};

}  // namespace batten::core
