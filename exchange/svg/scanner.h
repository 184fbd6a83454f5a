/// Goes through the text of an attribute: numbers, words and what separates them.
#pragma once

#include <cctype>
#include <optional>
#include <string_view>

#include "core/base/number_text.h"

namespace batten::exchange {

/// What separates words in attributes and in style sheets.
inline constexpr std::string_view svg_blanks = " \t\r\n\f";

class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::size_t place() const { return at_; }
    bool is_at_end() const { return at_ == text_.size(); }

    /// The next character; a zero byte at the end.
    char next() const { return is_at_end() ? '\0' : text_[at_]; }

    void skip() { ++at_; }

    void skip_blanks() {
        while (!is_at_end() && svg_blanks.find(text_[at_]) != std::string_view::npos) ++at_;
    }

    /// Blanks with at most one comma among them.
    void skip_separator() {
        skip_blanks();
        if (next() != ',') return;
        skip();
        skip_blanks();
    }

    /// Skips `character` where it is the next one.
    bool skip_if(char character) {
        if (next() != character) return false;
        skip();
        return true;
    }

    /// The number that stands here and nothing behind it; none where there is none, or one that is no double.
    std::optional<double> number() {
        const auto found = core::leading_number(text_.substr(at_));
        if (!found) return std::nullopt;
        at_ += found->length;
        return found->value;
    }

    /// The letters that stand here, and % signs; empty where there are none.
    std::string_view word() {
        const std::size_t start = at_;
        while (std::isalpha(static_cast<unsigned char>(next())) != 0 || next() == '%') ++at_;
        return text_.substr(start, at_ - start);
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace batten::exchange
