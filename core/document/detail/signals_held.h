/// Keeps signals from ending the program between making a file and removing it.
#pragma once

#include <csignal>

namespace batten::core {

/// While it lives, signals to the thread wait, but for those that cannot. That a file grew beyond the limit of its size
/// is also what the writing call answers, so that signal is dropped.
class SignalsHeld {
  public:
    SignalsHeld() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before_);
        was_beyond_limit_ = is_beyond_limit();
    }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;
    ~SignalsHeld() {
        if (!was_beyond_limit_ && is_beyond_limit()) drop_beyond_limit();
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    static bool is_beyond_limit() {
        sigset_t waiting;
        return sigpending(&waiting) == 0 && sigismember(&waiting, SIGXFSZ) == 1;
    }

    static void drop_beyond_limit() {
        sigset_t only;
        sigemptyset(&only);
        sigaddset(&only, SIGXFSZ);
        int found = 0;
        sigwait(&only, &found);
    }

    sigset_t before_{};
    bool was_beyond_limit_ = false;
};

}  // namespace batten::core
