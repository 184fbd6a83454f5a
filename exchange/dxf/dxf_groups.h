/// The groups of a DXF file in its text form: pairs of lines, of which the first is a code and the second a value.
#pragma once

#include <optional>
#include <string_view>

#include "core/document/file_text.h"

namespace batten::exchange {

struct DxfGroup {
    int code = 0;
    std::string_view value{};  ///< without blanks around it
    std::size_t line = 0;      ///< of the value, counted from 1
};

class DxfGroups {
  public:
    /// `text` must outlive the groups.
    explicit DxfGroups(std::string_view text) : rest_(text) {}

    /// The next group that is no comment. None at the end of the text, and where a line is no code: error() says so.
    std::optional<DxfGroup> next();

    const std::optional<core::FileError>& error() const { return error_; }

    /// The line that was read last.
    std::size_t line() const { return line_; }

  private:
    std::string_view take_line();
    std::optional<DxfGroup> refuse(std::string what);

    std::string_view rest_;
    std::size_t line_ = 0;
    std::optional<core::FileError> error_{};
};

}  // namespace batten::exchange
