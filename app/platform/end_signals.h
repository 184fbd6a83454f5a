/// Signals that ask the program to end.
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <optional>
#include <thread>

namespace batten::platform {

/// While it lives, SIGTERM, SIGINT and SIGHUP (but those that are ignored) do not end the program at once, so that no
/// thread is stopped while it saves. Whoever asks a second time is not kept waiting.
class EndSignals {
  public:
    /// To be made before other threads, which inherit what they hold back. `wake` is called from another thread when
    /// one came.
    explicit EndSignals(std::function<void()> wake);
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    /// Whether one came.
    bool is_asked() const { return asked_ != 0; }

    /// Ends the program by the signal that came, as whoever sent it expects; returns where none came.
    void end_program() const;

  private:
    void watch(const std::function<void()>& wake);

    sigset_t before_{};
    sigset_t held_{};
    int signals_ = -1;  // a descriptor that tells them
    int ending_ = -1;   // likewise of the end of the thread
    std::atomic<int> asked_ = 0;
    std::jthread thread_;
};

}  // namespace batten::platform
