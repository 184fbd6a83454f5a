#include "app/platform/end_signals.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace batten::platform {
namespace {

using namespace std::chrono_literals;

void await(const std::atomic<bool>& is_so) {
    while (!is_so) std::this_thread::sleep_for(1ms);
}

// The signal that ends a process of its own, in which `run` is called; 0 where it ends otherwise.
int signal_that_ends(const std::function<void()>& run) {
    const pid_t process = fork();
    if (process == 0) {
        run();
        _exit(0);
    }
    int status = 0;
    waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

TEST(EndSignals, let_the_program_end_by_itself) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        std::atomic<bool> is_woken = false;
        {
            const EndSignals signals([&] { is_woken = true; });
            EXPECT_FALSE(signals.is_asked());
            kill(getpid(), signal);
            await(is_woken);
            EXPECT_TRUE(signals.is_asked());
        }
    }
}

TEST(EndSignals, do_not_stop_other_threads) {
    std::atomic<bool> is_woken = false;
    std::atomic<bool> goes_on = true;
    const EndSignals signals([&] { is_woken = true; });
    std::jthread worker([&] {
        while (goes_on) std::this_thread::yield();
    });
    kill(getpid(), SIGTERM);
    await(is_woken);
    goes_on = false;
}

TEST(EndSignals, end_the_program_by_the_one_that_came) {
    EXPECT_EQ(signal_that_ends([] {
                  std::atomic<bool> is_woken = false;
                  const EndSignals signals([&] { is_woken = true; });
                  signals.end_program();
                  kill(getpid(), SIGHUP);
                  await(is_woken);
                  signals.end_program();
              }),
              SIGHUP);
}

TEST(EndSignals, end_a_program_that_does_not_answer_the_second_time) {
    EXPECT_EQ(signal_that_ends([] {
                  std::atomic<bool> is_woken = false;
                  const EndSignals signals([&] { is_woken = true; });
                  kill(getpid(), SIGTERM);
                  await(is_woken);
                  for (;;) {
                      kill(getpid(), SIGINT);
                      std::this_thread::sleep_for(1ms);
                  }
              }),
              SIGINT);
}

TEST(EndSignals, leave_those_that_are_ignored) {
    EXPECT_EQ(signal_that_ends([] {
                  std::signal(SIGHUP, SIG_IGN);
                  std::atomic<bool> is_woken = false;
                  const EndSignals signals([&] { is_woken = true; });
                  kill(getpid(), SIGHUP);
                  kill(getpid(), SIGTERM);
                  await(is_woken);
                  signals.end_program();
              }),
              SIGTERM);
}

TEST(EndSignals, are_as_they_were_afterward) {
    sigset_t before;
    sigset_t after;
    pthread_sigmask(SIG_SETMASK, nullptr, &before);
    {
        const EndSignals signals([] {});
    }
    pthread_sigmask(SIG_SETMASK, nullptr, &after);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        EXPECT_EQ(sigismember(&before, signal), sigismember(&after, signal)) << signal;
}

}  // namespace
}  // namespace batten::platform
