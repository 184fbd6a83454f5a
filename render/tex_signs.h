/// What LaTeX calls signs that are no letters of its own, without packages, and the signs of its commands.
#pragma once

#include <optional>
#include <string_view>

namespace batten::render {

/// Whether `sign` is one of those that names of commands have.
inline bool is_letter(char sign) {
    return ('a' <= sign && sign <= 'z') || ('A' <= sign && sign <= 'Z');
}

/// In formulas: "\le " for "≤"; none where it has no such sign.
std::optional<std::string_view> math_sign(std::string_view sign);

/// In words: "\%" for "%".
std::optional<std::string_view> text_sign(std::string_view sign);

/// "≤" for the command "le", without its backslash; none for those that are no sign.
std::optional<std::string_view> sign_of_command(std::string_view command);

/// "ℝ" for 'R'.
std::optional<std::string_view> blackboard_sign(char letter);

/// "ⱼ" for "j" and '_', "²" for "2" and '^'.
std::optional<std::string_view> script_sign(char kind, std::string_view sign);

/// "⅙" for "1" and "6".
std::optional<std::string_view> fraction_sign(std::string_view upper, std::string_view lower);

}  // namespace batten::render
