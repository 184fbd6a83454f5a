/// What must hold of every format that is read and written.
#pragma once

#include "exchange/format.h"

namespace batten::fuzz {

/// Reads `bytes` as `format`: curves, or a sentence. What was read is written, and read again as so many curves.
void run_format(exchange::Format format, std::string_view bytes);

}  // namespace batten::fuzz
