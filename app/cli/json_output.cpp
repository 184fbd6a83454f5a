#include "app/cli/json_output.h"

#include <ostream>

namespace batten::cli {

void print(std::ostream& out, const Json& json) {
    constexpr int indent = 2;
    out << json.dump(indent, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace batten::cli
