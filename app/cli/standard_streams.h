/// Standard input and output: their names on the command line, and what can go wrong with them.
#pragma once

#include <filesystem>
#include <streambuf>
#include <string>
#include <string_view>

#include "app/cli/subcommands.h"

namespace batten::cli {

/// Its file descriptor.
inline constexpr int standard_input = 0;

/// Whether `file` stands for standard input or output.
inline bool is_standard(const std::filesystem::path& file) {
    return file == "-";
}

/// To be called before anything is read or written. Gives standard streams that are closed a place where reading and
/// writing fail, so that no file that is opened takes it; makes writing to a closed pipe, or beyond the limit of file
/// sizes, an error instead of the end of the program.
void guard_standard_streams();

/// What sentences call a file that is read: "standard input" or its path.
std::string shown_name(const std::filesystem::path& file);

/// What they call one that is written: "standard output" or its path.
std::string result_name(const std::filesystem::path& file);

/// Writes all results at once; false after saying why they could not be written, but for a pipe that nobody reads.
bool write_results(std::string_view results, Output output);

/// Results on their way to standard output. Up to a mebibyte they are held, so that what goes wrong leaves none of
/// them; longer ones take no more memory than that.
class ResultBuffer : public std::streambuf {
  public:
    explicit ResultBuffer(Output output) : output_(output) {}

    /// Writes what is held; false when anything could not be written, which is said once.
    bool finish();

  protected:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;

  private:
    Output output_;
    std::string held_;
    bool is_written_ = true;
};

}  // namespace batten::cli
