// covaria_fuzz KIND COUNT SEED [FOLDER [FIRST]]: makes inputs and counts what becomes of them; status 1 if
// any aborted, hung or was refused without a place. Inputs that did are left in FOLDER. covaria_fuzz KIND
// FILE runs one.
#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>

#include "tests/fuzz/fuzz.h"

namespace {

using namespace covaria::fuzz;
// The limits are of the processor's time: they do not depend on how busy the machine is.
constexpr int patience_s = 20;
constexpr double slow_s = 5.0;
constexpr unsigned longest_wait_s = 600;  // by the clock: something waits for what never comes

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

void watch_time(bool on) {
    const itimerval patience{{}, {on ? patience_s : 0, 0}};
    setitimer(ITIMER_PROF, &patience, nullptr);
    alarm(on ? longest_wait_s : 0);
}

// The input in work, for the handler, which may call next to nothing.
const std::string* current = nullptr;
char file_of_current[512] = "";

void save_current() {
    const int file = open(file_of_current, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0 || !current) return;
    [[maybe_unused]] const auto written = write(file, current->data(), current->size());
    close(file);
}

void on_crash(int signal) {
    save_current();
    const bool hangs = signal == SIGALRM || signal == SIGPROF;
    const char* words = hangs ? "HANG " : "ABORT ";
    [[maybe_unused]] auto written = write(STDOUT_FILENO, words, strlen(words));
    written = write(STDOUT_FILENO, file_of_current, strlen(file_of_current));
    written = write(STDOUT_FILENO, "\n", 1);
    _exit(hangs ? 4 : 3);
}

void watch_signals() {
    static char stack[1 << 16];
    const stack_t other{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
    sigaltstack(&other, nullptr);
    struct sigaction action = {};
    action.sa_handler = on_crash;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGALRM, SIGPROF})
        sigaction(signal, &action, nullptr);
}

std::unique_ptr<Kind> kind_named(const std::string& name) {
    if (name == "projects") return project_kind();
    if (name == "equations") return equation_kind();
    if (name == "csv") return csv_kind();
    if (name == "urdf") return urdf_kind();
    if (name == "stl") return stl_kind();
    if (name == "readers") return reader_kind();
    return nullptr;
}

struct Count {
    std::uint64_t inputs = 0, accepted = 0, evaluated = 0, complaints = 0, slow = 0;
    double slowest = 0.0;
};

void run_one(Kind& kind, const std::string& input, Count& count) {
    current = &input;
    watch_time(true);
    const double begin = processor_seconds();
    const Outcome outcome = kind.run(input);
    const double seconds = processor_seconds() - begin;
    watch_time(false);
    ++count.inputs;
    count.accepted += outcome.accepted;
    count.evaluated += outcome.evaluated;
    count.slowest = std::max(count.slowest, seconds);
    count.slow += seconds > slow_s;
    if (!outcome.complaint.empty() && ++count.complaints <= 20)
        std::printf("COMPLAINT %s: %s\n", file_of_current, outcome.complaint.c_str());
    if (!outcome.complaint.empty() || seconds > slow_s) save_current();
}

}  // namespace

int main(int argc, char** argv) {
    const auto kind = argc >= 3 ? kind_named(argv[1]) : nullptr;
    if (!kind)
        return std::fputs("covaria_fuzz projects|equations|csv|urdf|readers COUNT SEED [FOLDER [FIRST]]\n",
                          stderr),
               2;
    watch_signals();
    Count count;
    if (argc == 3) {
        std::strncpy(file_of_current, "input-in-work", sizeof file_of_current - 1);
        run_one(*kind, file_text(argv[2]), count);
        std::printf("accepted %d, evaluated %d, complaints %d, %.3f s\n", int(count.accepted),
                    int(count.evaluated), int(count.complaints), count.slowest);
        return count.complaints > 0;
    }
    const std::uint64_t number = std::strtoull(argv[2], nullptr, 10),
                        seed = std::strtoull(argv[3], nullptr, 10);
    const std::string folder = argc > 4 ? argv[4] : ".";
    const std::uint64_t first = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 0;
    std::filesystem::create_directories(folder);
    for (std::uint64_t i = first; i < first + number; ++i) {
        std::snprintf(file_of_current, sizeof file_of_current, "%s/fuzz-%s-%llu-%llu", folder.c_str(),
                      argv[1], static_cast<unsigned long long>(seed), static_cast<unsigned long long>(i));
        Noise noise(seed, i);
        const std::string input = kind->make(noise);
        run_one(*kind, input, count);
    }
    std::printf(
        "%s seed %llu: %llu inputs, %llu accepted, %llu evaluated, %llu complaints, %llu above %.0f s, "
        "slowest %.3f s\n",
        argv[1], static_cast<unsigned long long>(seed), static_cast<unsigned long long>(count.inputs),
        static_cast<unsigned long long>(count.accepted), static_cast<unsigned long long>(count.evaluated),
        static_cast<unsigned long long>(count.complaints), static_cast<unsigned long long>(count.slow),
        slow_s, count.slowest);
    return count.complaints + count.slow > 0 ? 1 : 0;
}
