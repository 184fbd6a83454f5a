/// The text of a STEP file, sign by sign, and as OpenCASCADE reads it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace batten::exchange {

/// The number of an instance.
using StepId = std::uint64_t;

/// Whether a word of STEP begins with `c`; those that programs make up begin with '!'.
bool begins_step_word(char c);

/// Goes through the text of a file from sign to sign.
class StepText {
  public:
    /// `text` must outlive it.
    explicit StepText(std::string_view text) : text_(text) {}

    std::size_t at() const { return at_; }
    std::string_view rest() const { return text_.substr(at_); }
    bool is_at_end() const { return at_ == text_.size(); }
    void go_on(std::size_t count = 1);

    void skip_byte_order_mark();

    /// The sign behind blanks and comments, which is next then; zero at the end.
    char next();

    /// Takes the next sign where it is `c`.
    bool take(char c);

    /// Takes what stands in quotes, of which a pair inside stands for one; false where that has no end.
    bool take_quoted(char quote);

    std::string_view take_word();     ///< empty where there is none
    std::optional<StepId> take_id();  ///< the number behind '#'
    bool take_number();
    void skip_statement();  ///< to its end, which is not looked at

  private:
    void skip_comment();

    std::string_view text_;
    std::size_t at_ = 0;
};

/// `text` as OpenCASCADE reads it: without its byte order mark and empty statements, as in ";;", and with the number of
/// each instance beside its '=', which it does not know where a line or a comment ends between them. Cost O(n).
std::string step_text_for_occt(std::string_view text);

}  // namespace batten::exchange
