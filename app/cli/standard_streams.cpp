#include "app/cli/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ostream>

#include "core/base/sentence.h"

namespace batten::cli {

namespace {

constexpr std::size_t most_held = std::size_t{1} << 20U;

}  // namespace

void guard_standard_streams() {
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (fcntl(stream, F_GETFD) >= 0) continue;
        // The lowest number that is free is this one.
        if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) return;
    }
}

std::string shown_name(const std::filesystem::path& file) {
    return is_standard(file) ? "standard input" : file.string();
}

std::string result_name(const std::filesystem::path& file) {
    return is_standard(file) ? "standard output" : file.string();
}

bool write_results(std::string_view results, Output output) {
    errno = 0;
    output.results << results << std::flush;
    const int reason = errno != 0 ? errno : EIO;
    if (output.results) return true;
    if (reason != EPIPE)
        output.errors << core::sentence("standard output: the results cannot be written: {reason}",
                                        {{"reason", std::strerror(reason)}})
                      << '\n';
    return false;
}

bool ResultBuffer::finish() {
    is_written_ = is_written_ && write_results(held_, output_);
    held_.clear();
    return is_written_;
}

ResultBuffer::int_type ResultBuffer::overflow(int_type character) {
    const char text = traits_type::to_char_type(character);
    return xsputn(&text, 1) == 1 ? character : traits_type::eof();
}

std::streamsize ResultBuffer::xsputn(const char* text, std::streamsize size) {
    held_.append(text, static_cast<std::size_t>(size));
    return held_.size() < most_held || finish() ? size : 0;
}

}  // namespace batten::cli
