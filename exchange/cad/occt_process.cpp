#include "exchange/cad/occt_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "core/document/native_file.h"
#include "exchange/refusal.h"

namespace batten::exchange {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_answer_bytes = 2 * core::most_file_bytes;

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(std::exchange(number_, -1));
    }

  private:
    int number_;
};

std::filesystem::path program_path() {
    if (const char* path = std::getenv("BATTEN_OCCT")) return path;
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const std::filesystem::path beside = folder / "batten-occt";
    return std::filesystem::exists(beside, error) ? beside : folder.parent_path() / "libexec/batten/batten-occt";
}

bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = write(descriptor, text.data(), text.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return lseek(descriptor, 0, SEEK_SET) == 0;
}

// Whether there is something to read, or the end, before `deadline`.
bool can_read(int descriptor, Clock::time_point deadline) {
    pollfd asked{.fd = descriptor, .events = POLLIN, .revents = 0};
    for (;;) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
        const int count = poll(&asked, 1, static_cast<int>(std::max<std::int64_t>(left, 0)));
        if (count >= 0 || errno != EINTR) return count > 0;
    }
}

// All that comes before `deadline`, and at most so much; none where it cannot be read.
std::optional<std::string> read_all(int descriptor, Clock::time_point deadline) {
    std::string text;
    std::array<char, 1U << 16U> block{};
    while (text.size() <= most_answer_bytes && can_read(descriptor, deadline)) {
        const ssize_t count = read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        if (count == 0) return text;
        text.append(block.data(), static_cast<std::size_t>(count));
    }
    return std::nullopt;
}

// A process holds back no signals, whatever this one holds back while it saves or waits for its end.
class FreeSignals {
  public:
    FreeSignals() {
        is_made_ = posix_spawnattr_init(&attributes_) == 0;
        if (!is_made_) return;
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
    }
    ~FreeSignals() {
        if (is_made_) posix_spawnattr_destroy(&attributes_);
    }
    FreeSignals(const FreeSignals&) = delete;
    FreeSignals& operator=(const FreeSignals&) = delete;

    const posix_spawnattr_t* attributes() const { return is_made_ ? &attributes_ : nullptr; }

  private:
    posix_spawnattr_t attributes_{};
    bool is_made_ = false;
};

std::optional<pid_t> start(const std::filesystem::path& program, const char* task, const char* format, int input,
                           int output) {
    std::array<std::string, 3> words{program.string(), task, format};
    std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    posix_spawn_file_actions_t actions;
    if (posix_spawn_file_actions_init(&actions) != 0) return std::nullopt;
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    const FreeSignals free;
    pid_t process = 0;
    const int error = posix_spawn(&process, program.c_str(), &actions, free.attributes(), arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? std::optional(process) : std::nullopt;
}

// The limit of processor time ends a process by these.
bool is_end_of_time(int signal) {
    return signal == SIGXCPU || signal == SIGKILL;
}

enum class End { well, badly, late };

// Waits for the end of `process`, and brings it about after `deadline`.
End end_of(pid_t process, Clock::time_point deadline) {
    constexpr auto pause = std::chrono::milliseconds(1);
    int status = 0;
    for (;;) {
        const bool is_late = Clock::now() >= deadline;
        if (is_late) kill(process, SIGKILL);
        const pid_t ended = waitpid(process, &status, is_late ? 0 : WNOHANG);
        if (ended > 0 && (is_late || (WIFSIGNALED(status) && is_end_of_time(WTERMSIG(status))))) return End::late;
        if (ended > 0) return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? End::well : End::badly;
        if (ended < 0 && errno != EINTR) return End::badly;
        if (ended == 0) std::this_thread::sleep_for(pause);
    }
}

core::FileResult<OcctAnswer> answer_of(const std::string& text) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) return refused_file("batten-occt gave no answer");
    if (json.contains("what")) return refused_file(json.value("what", ""), json.value("where", ""));
    // Infinity has no number in JSON.
    const auto error = json.find("largest_error");
    const bool is_known = error != json.end() && error->is_number();
    return OcctAnswer{json.value("text", ""),
                      {is_known ? error->get<double>() : std::numeric_limits<double>::infinity(),
                       json.value("left_out", std::vector<std::string>())}};
}

}  // namespace

core::FileResult<OcctAnswer> ask_occt(const char* task, const char* format, std::string_view text,
                                      std::chrono::milliseconds most_time) {
    const Descriptor input(memfd_create("batten", MFD_CLOEXEC));
    std::array<int, 2> ends{-1, -1};
    if (input.number() < 0 || !write_all(input.number(), text) || pipe2(ends.data(), O_CLOEXEC) != 0)
        return refused_file("there is not enough memory to hand it over to OpenCASCADE");
    Descriptor output(ends[0]);
    Descriptor output_of_program(ends[1]);
    const Clock::time_point deadline = Clock::now() + most_time;
    const auto process = start(program_path(), task, format, input.number(), ends[1]);
    output_of_program.close();
    if (!process)
        return refused_file(
            "the program batten-occt cannot be started; it must stand beside batten or in "
            "libexec/batten");
    const std::optional<std::string> answer = read_all(output.number(), deadline);
    output.close();
    const bool is_late = Clock::now() >= deadline;
    const End end = end_of(*process, answer ? deadline : Clock::now());
    if (!answer && !is_late && end == End::late)
        return refused_file("OpenCASCADE makes more than 256 MiB of this file");
    if (end == End::late) return refused_file("OpenCASCADE takes more than a minute for this file");
    if (end == End::badly || !answer) return refused_file("OpenCASCADE fails on this file");
    return answer_of(*answer);
}

core::FileResult<Imported> read_through_occt(const char* format, std::string_view text) {
    auto answer = ask_occt("read", format, text);
    if (!answer) return tl::unexpected(answer.error());
    auto document = core::parse_document(answer->text);
    if (!document) return tl::unexpected(document.error());
    return Imported{*std::move(document), std::move(answer->report)};
}

core::FileResult<Exported> write_through_occt(const char* format, const core::Document& document) {
    auto answer = ask_occt("write", format, core::format_document(document));
    if (!answer) return tl::unexpected(answer.error());
    return Exported{std::move(answer->text), std::move(answer->report)};
}

}  // namespace batten::exchange
