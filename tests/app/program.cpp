#include "tests/app/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>

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

/// It listens to signals (they are blocked, for a thread that waits for them), and then has computed for a
/// while or waits: for its workers, for a pipe. So is a process that has ended already.
bool is_at_work(pid_t process) {
    const std::string folder = "/proc/" + std::to_string(process);
    const std::string status = read_text(folder + "/status");
    const auto blocked = status.find("SigBlk:");
    if (blocked == std::string::npos || status.find("State:\tZ") != std::string::npos) return true;
    if ((std::stoull(status.substr(blocked + 7), nullptr, 16) & (1u << (SIGINT - 1))) == 0) return false;
    std::istringstream times(read_text(folder + "/stat"));
    std::string field;
    for (int i = 0; i < 13; ++i) times >> field;
    long in_program = 0;
    times >> in_program;
    return status.find("State:\tS") != std::string::npos || in_program > sysconf(_SC_CLK_TCK) / 5;
}

}  // namespace

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

Outcome run_program(const std::vector<std::string>& arguments, Ending ending) {
    return run_program_with({}, arguments, ending);
}

Outcome run_program_with(const std::vector<std::string>& environment,
                         const std::vector<std::string>& arguments, Ending ending) {
    char pattern[] = "/tmp/covaria-test-XXXXXX";
    const fs::path folder = mkdtemp(pattern);
    const pid_t child = fork();
    if (child == 0) become_program(environment, arguments, folder / "out", folder / "err");
    if (ending == Ending::interrupted) {
        while (!is_at_work(child)) usleep(1000);
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
