/// What a user wrote, like a title: words, and formulas between dollar signs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/figure.h"

namespace batten::render {

struct ProsePart {
    std::string_view text;  ///< of `prose`; of a formula without its dollar signs
    bool is_formula = false;
};

/// The parts in order. A formula begins with a dollar sign before a sign that is no blank and ends with one behind such
/// a sign and before no digit, so that prices are none; its braces are balanced, no command or script lacks what it is
/// of, and it has no %, #, & and ~. Of a dollar sign behind a backslash, which is never one of a formula, the backslash
/// is in no part.
std::vector<ProsePart> prose_parts(std::string_view prose);

/// The text in the notation of Label: "$P_3$ on the curve" as "P_{3} on the curve", formulas by formula_label.
std::string prose_label(std::string_view prose);

/// The commands of its formulas that stand there as they were typed, in order.
std::vector<std::string> unset_commands(std::string_view prose);

/// What painters that know no formulas draw of a part.
DrawList set_list(const FigurePart& part);

}  // namespace batten::render
