/// Turns text into a JSON tree that is safe to work on, or says where the text goes wrong.
#pragma once

#include "core/document/detail/native_format.h"
#include "core/document/detail/text_stream.h"
#include "core/document/native_file.h"

namespace batten::core {

/// What a text may have beside the packed numbers: so many bytes, and so many values. Both stand for memory, of which
/// a tree takes far more than its text.
inline constexpr std::size_t most_other_bytes = std::size_t{16} << 20U;
inline constexpr std::size_t most_values = 4'000'000;

/// The tree of `text`, in which the lists of numbers of curves (/curves/i/knots, points, weights, and points,
/// parameters and handles of its fit) are packed as number_list.h says. Refused with "line L, column C": anything that
/// is not JSON, numbers too large for a double, text that is not UTF-8, nesting, members, values or bytes beyond the
/// limits, a member that occurs twice in one object. Also: what ended the text early. `points_read` is told the points
/// that are packed.
[[nodiscard]] FileResult<Json> parse_json(TextStream& text, const PointsRead& points_read = {});

}  // namespace batten::core
