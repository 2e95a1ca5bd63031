// covaria submit FILE --slurm: the script that computes the parts of a run on several machines.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/shared_run.h"
#include "app/terminal.h"
#include "app/whole_number.h"

namespace covaria {
namespace {

struct SubmitArguments {
    RunRequest request;
    bool slurm = false, parallel = false, mpi = false;
    std::uint64_t parts = 400;
    std::string folder = "parts";
    std::string out = "out";
};

/// The text as one word of a shell.
std::string quoted(const std::string& text) {
    if (!text.empty() &&
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-") ==
            std::string::npos)
        return text;
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

std::string with_arguments(const std::string& command, const SubmitArguments& arguments) {
    std::string line = command + " " + quoted(std::filesystem::absolute(arguments.request.file).string());
    for (const std::string& argument : arguments_of(arguments.request)) line += " " + quoted(argument);
    return line + " --threads " + std::to_string(std::max(1, arguments.request.threads));
}

std::string script(const SubmitArguments& arguments) {
    const std::string n = std::to_string(arguments.parts), parts = quoted(arguments.folder),
                      out = quoted(arguments.out),
                      cores = std::to_string(std::max(1, arguments.request.threads)),
                      part =
                          with_arguments("covaria part", arguments) + " --resume --out " + parts + " --part ";
    const std::string merge = "covaria merge " + parts + " --out " + out;
    if (arguments.slurm)
        return "#!/bin/bash\n"
               "# sbatch THIS; what failed is computed when it is submitted again; then: " +
               merge +
               "\n"
               "#SBATCH --job-name=covaria\n"
               "#SBATCH --array=1-" +
               n + "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=" + cores + "\nset -euo pipefail\n" + part +
               "\"$SLURM_ARRAY_TASK_ID\"/" + n + "\n";
    if (arguments.mpi)
        return "#!/bin/bash\n"
               "# sbatch THIS, or run it on one machine with SLURM_NTASKS=4. Again: goes on where it ended.\n"
               "#SBATCH --job-name=covaria\n"
               "#SBATCH --ntasks=32\n"
               "#SBATCH --cpus-per-task=" +
               cores + "\nset -euo pipefail\nmpirun -n \"$SLURM_NTASKS\" " +
               with_arguments("covaria-mpi run", arguments) + " --resume --journal " + parts + " --out " +
               out + "\n";
    return "#!/bin/bash\n"
           "# On several machines: parallel --sshloginfile MACHINES ... where they share this folder.\n"
           "set -euo pipefail\n"
           "seq " +
           n + " | parallel --halt soon,fail=1 " + quoted(part + "{}/" + n) + "\n" + merge + "\n";
}

Result<void> submit(const SubmitArguments& arguments) {
    if (arguments.slurm + arguments.parallel + arguments.mpi != 1)
        return fail(ErrorCode::usage, "say for what: --slurm, --parallel or --mpi");
    if (auto opened = open_project(arguments.request.file, arguments.request.values); !opened)
        return fail(opened.error());
    std::fputs(script(arguments).c_str(), stdout);
    return {};
}

}  // namespace

Command submit_command(CLI::App& app) {
    auto arguments = std::make_shared<SubmitArguments>();
    CLI::App* command =
        app.add_subcommand("submit", "Print the script that computes the parts of a run on several machines");
    add_examples(*command, {{"submit projects/stewart-platform.covaria --trials 1e9 --slurm --parts 400",
                             "to be saved, and given to sbatch"},
                            {"submit projects/stewart-platform.covaria --parallel --parts 16"}});
    add_run_options(*command, arguments->request);
    command->add_flag("--slurm", arguments->slurm, "an array of jobs for Slurm");
    command->add_flag("--parallel", arguments->parallel, "for GNU parallel");
    command->add_flag("--mpi", arguments->mpi, "one job of covaria-mpi");
    takes_whole_number(command->add_option("--parts", arguments->parts, "number of parts")
                           ->type_name("N")
                           ->check(CLI::Range(1, 1'000'000))
                           ->capture_default_str());
    command->add_option("--parts-folder", arguments->folder, "folder for the parts")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_option("--out", arguments->out, "folder for the results")
        ->type_name("DIR")
        ->capture_default_str();
    return {command, [arguments](const std::stop_token&) {
                const auto done = submit(*arguments);
                if (done) return int(exit_success);
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
