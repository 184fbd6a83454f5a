#include "app/platform/end_signals.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>

namespace batten::platform {

namespace {

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// Waits until one of both has something to read. Returns whether it is the first one.
bool is_first_of(int first, int second) {
    std::array<pollfd, 2> asked{pollfd{first, POLLIN, 0}, pollfd{second, POLLIN, 0}};
    while (poll(asked.data(), asked.size(), -1) < 0 && errno == EINTR) continue;
    return asked[1].revents == 0 && (asked[0].revents & POLLIN) != 0;
}

}  // namespace

EndSignals::EndSignals(std::function<void()> wake) {
    sigemptyset(&held_);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        if (!is_ignored(signal)) sigaddset(&held_, signal);
    signals_ = signalfd(-1, &held_, SFD_CLOEXEC);
    ending_ = eventfd(0, EFD_CLOEXEC);
    if (signals_ < 0 || ending_ < 0) sigemptyset(&held_);  // they end the program as ever
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
    thread_ = std::jthread([this, wake = std::move(wake)] { watch(wake); });
}

EndSignals::~EndSignals() {
    const std::uint64_t one = 1;
    static_cast<void>(write(ending_, &one, sizeof(one)));
    thread_.join();
    close(signals_);
    close(ending_);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void EndSignals::watch(const std::function<void()>& wake) {
    signalfd_siginfo found{};
    if (signals_ < 0 || ending_ < 0 || !is_first_of(signals_, ending_)) return;
    if (read(signals_, &found, sizeof(found)) != static_cast<ssize_t>(sizeof(found))) return;
    asked_ = static_cast<int>(found.ssi_signo);
    wake();
    // The next one finds this thread, and ends the program.
    pthread_sigmask(SIG_UNBLOCK, &held_, nullptr);
    is_first_of(ending_, ending_);
}

void EndSignals::end_program() const {
    if (!is_asked()) return;
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    sigaction(asked_, &usual, nullptr);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, asked_);
    raise(asked_);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
}

}  // namespace batten::platform
