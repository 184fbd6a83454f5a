#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <cstdio>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/document/native_file.h"
#include "exchange/occt/drawing.h"

// batten-occt read|write iges|step: a file on standard input, and on standard output what the process_text of
// exchange/cad/occt_process.h expects. A program of its own, so that a file on which OpenCASCADE fails takes nothing
// with it, and so that nobody waits for its libraries who has no such file.

namespace batten::exchange::occt {

namespace {

using Json = nlohmann::json;

constexpr rlim_t most_memory = rlim_t{4} << 30U;
constexpr rlim_t most_seconds = 60;

void limit(decltype(RLIMIT_CPU) resource, rlim_t most) {
    const rlimit limits{most, most};
    setrlimit(resource, &limits);
}

void set_limits() {
    limit(RLIMIT_CPU, most_seconds);
    limit(RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__
    limit(RLIMIT_AS, most_memory);
#endif
}

// What OpenCASCADE prints goes nowhere.
std::FILE* take_standard_output() {
    const int results = dup(STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    if (results < 0 || nowhere < 0) return nullptr;
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    return fdopen(results, "w");
}

Json json_of_error(const core::FileError& error) {
    return {{"where", error.where}, {"what", error.what}};
}

Json json_of_result(const std::string& text, const Report& report) {
    return {{"text", text}, {"largest_error", report.largest_error}, {"left_out", report.left_out}};
}

Json read_answer(std::string_view format) {
    if (format == "iges") {
        const auto imported = read_iges("/proc/self/fd/0");
        return imported ? json_of_result(core::format_document(imported->document), imported->report)
                        : json_of_error(imported.error());
    }
    const auto text = core::read_text(STDIN_FILENO, "standard input");
    if (!text) return json_of_error(text.error());
    const auto imported = read_step(*text);
    return imported ? json_of_result(core::format_document(imported->document), imported->report)
                    : json_of_error(imported.error());
}

Json write_answer(std::string_view format) {
    const auto document = core::load_document(STDIN_FILENO, "standard input");
    if (!document) return json_of_error(document.error());
    const auto exported = format == "iges" ? write_iges(*document) : write_step(*document);
    return exported ? json_of_result(exported->text, exported->report) : json_of_error(exported.error());
}

Json answer(std::string_view task, std::string_view format) {
    try {
        return task == "read" ? read_answer(format) : write_answer(format);
    } catch (const std::bad_alloc&) {
        return json_of_error({.where = {}, .what = "OpenCASCADE needs more than 4 GB for this file"});
    } catch (const Standard_OutOfMemory&) {
        return json_of_error({.where = {}, .what = "OpenCASCADE needs more than 4 GB for this file"});
    } catch (const Standard_Failure&) {
        return json_of_error({.where = {}, .what = "OpenCASCADE fails on this file"});
    } catch (const std::exception&) {
        return json_of_error({.where = {}, .what = "OpenCASCADE fails on this file"});
    }
}

bool is_one_of(std::string_view word, std::string_view a, std::string_view b) {
    return word == a || word == b;
}

int run(std::string_view task, std::string_view format) {
    if (!is_one_of(task, "read", "write") || !is_one_of(format, "iges", "step")) return 2;
    set_limits();
    std::FILE* results = take_standard_output();
    if (results == nullptr) return 1;
    const std::string text = answer(task, format).dump(-1, ' ', false, Json::error_handler_t::replace);
    const bool is_written = std::fwrite(text.data(), 1, text.size(), results) == text.size();
    return is_written && std::fflush(results) == 0 ? 0 : 1;
}

}  // namespace

}  // namespace batten::exchange::occt

int main(int count, char** words) {
    int status = 2;
    try {
        if (count == 3) status = batten::exchange::occt::run(words[1], words[2]);
    } catch (...) {
        status = 1;
    }
    // Without the destructors of OpenCASCADE's statics, which take their time.
    _exit(status);
}
