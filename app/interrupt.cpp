#include "app/interrupt.h"

#include <unistd.h>
#include <csignal>
#include <ctime>

#include "app/exit_status.h"

namespace covaria {
namespace {

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

void watch(const std::stop_token& end, std::stop_source& source) {
    const sigset_t set = watched_signals();
    const timespec patience{0, 50'000'000};
    while (!end.stop_requested()) {
        if (sigtimedwait(&set, nullptr, &patience) < 0) continue;
        if (source.stop_requested()) _exit(exit_interrupted);
        source.request_stop();
    }
}

}  // namespace

Interrupt::Interrupt() {
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    watcher_ = std::jthread([this](const std::stop_token& end) { watch(end, source_); });
}

}  // namespace covaria
