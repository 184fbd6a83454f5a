/// Numbers as text that reads back to the same double.
#pragma once

#include <string>

namespace batten::core {

/// The shortest such text, "0.1", whatever the locale.
std::string shortest_text(double value);

}  // namespace batten::core
