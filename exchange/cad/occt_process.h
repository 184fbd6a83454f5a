/// Asks the program batten-occt, by which files are read and written through OpenCASCADE.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "exchange/report.h"

namespace batten::exchange {

/// A text and what is to be said of it.
struct OcctAnswer {
    std::string text;
    Report report{};
};

/// What `batten-occt task format` makes of `text`. The program stands beside this one or in ../libexec/batten, or where
/// the environment variable BATTEN_OCCT says. It is a process of its own, which may take at most a minute of
/// the processor, `most_time` by the clock and 4 GB and whose end is an error like others. Errors: those that it tells;
/// it is not there; it came to no end, or its answer did not.
core::FileResult<OcctAnswer> ask_occt(const char* task, const char* format, std::string_view text,
                                      std::chrono::milliseconds most_time = std::chrono::minutes(2));

/// The curves of a file, or the text of one: "iges" or "step".
core::FileResult<Imported> read_through_occt(const char* format, std::string_view text);
core::FileResult<Exported> write_through_occt(const char* format, const core::Document& document);

}  // namespace batten::exchange
