#include "core/document/json_check.h"

#include "core/document/detail/json_text.h"

namespace batten::core {

FileResult<void> check_json(std::string_view text) {
    TextStream stream(text);
    return parse_json(stream).map([](const Json&) {});
}

}  // namespace batten::core
