#include "app/interrupt.h"

#include <unistd.h>
#include <chrono>
#include <csignal>
#include <ctime>

#include "app/exit_status.h"
#include "core/base/file_io.h"

namespace covaria {
namespace {

sigset_t watched_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

// Evaluations end by themselves, with a message, well before this; what knows no stop is ended.
constexpr std::chrono::milliseconds grace{350};

[[noreturn]] void leave() {
    remove_unfinished_files();
    static constexpr char message[] = "covaria: stopped\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message, sizeof message - 1);
    _exit(exit_interrupted);
}

void watch(const std::stop_token& end, std::stop_source& source) {
    const sigset_t set = watched_signals();
    const timespec patience{0, 50'000'000};
    while (!end.stop_requested()) {
        if (sigtimedwait(&set, nullptr, &patience) < 0) continue;
        if (source.stop_requested()) leave();
        source.request_stop();
        std::thread([end] {
            std::this_thread::sleep_for(grace);
            if (!end.stop_requested()) leave();
        }).detach();
    }
}

}  // namespace

Interrupt::Interrupt() {
    const sigset_t set = watched_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    watcher_ = std::jthread([this](const std::stop_token& end) { watch(end, source_); });
}

}  // namespace covaria
