/// Goes through a JSON text and tells what it says, for readers of files that are kept in trees of another kind.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "core/document/file_text.h"

namespace batten::core {

/// Null, true or false, a number, or a text.
using JsonScalar = std::variant<std::monostate, bool, double, std::string>;

/// Is told what a text says, in its order. Each function returns whether to go on; where not, refusal() says why.
class JsonListener {
  public:
    virtual ~JsonListener() = default;

    virtual bool scalar(JsonScalar value) = 0;
    virtual bool begin_list() = 0;
    virtual bool end_list() = 0;
    virtual bool begin_object() = 0;
    virtual bool end_object() = 0;

    /// Of the member whose value follows.
    virtual bool name(std::string name) = 0;

    virtual std::string refusal() const = 0;
};

/// Tells `listener` what `text` says, until the first defect. Refused with "line L, column C": what check_json
/// (json_check.h) refuses, but for the numbers of values and bytes; what `listener` refuses. Cost O(n log m) for m
/// members of an object, and the memory of their names.
[[nodiscard]] FileResult<void> walk_json(std::string_view text, JsonListener& listener);

}  // namespace batten::core
