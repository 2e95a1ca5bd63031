#include "tests/app/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

namespace fs = std::filesystem;

namespace {

[[noreturn]] void become_program(const std::vector<std::string>& environment,
                                 const std::vector<std::string>& arguments, const fs::path& out,
                                 const fs::path& err) {
    const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(out_file, STDOUT_FILENO);
    dup2(err_file, STDERR_FILENO);
    std::vector<char*> argv{const_cast<char*>(COVARIA_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    for (const std::string& variable : environment) putenv(const_cast<char*>(variable.c_str()));
    execv(COVARIA_PROGRAM, argv.data());
    _exit(127);
}

}  // namespace

fs::path fresh_folder(const std::string& name) {
    const fs::path folder = fs::path(COVARIA_BINARY_DIR) / "test-files" / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::string read_text(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

fs::path shipped_project(const std::string& name) {
    return fs::path(COVARIA_SOURCE_DIR) / "projects" / name;
}

Outcome run_program(const std::vector<std::string>& arguments, int signal_after_ms) {
    return run_program_with({}, arguments, signal_after_ms);
}

Outcome run_program_with(const std::vector<std::string>& environment,
                         const std::vector<std::string>& arguments, int signal_after_ms) {
    char pattern[] = "/tmp/covaria-test-XXXXXX";
    const fs::path folder = mkdtemp(pattern);
    const pid_t child = fork();
    if (child == 0) become_program(environment, arguments, folder / "out", folder / "err");
    if (signal_after_ms > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(signal_after_ms));
        kill(child, SIGINT);
    }
    const auto sent = std::chrono::steady_clock::now();
    int status = 0;
    waitpid(child, &status, 0);
    const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - sent;
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                    read_text(folder / "out"), read_text(folder / "err"), waited.count()};
    fs::remove_all(folder);
    return outcome;
}
