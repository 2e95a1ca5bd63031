// The program: a window without a subcommand, a headless tool with one.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/printed_text.h"
#include "app/terminal.h"
#include "app/window.h"
#include "app/wrong_usage.h"
#include "core/base/guarded.h"
#include "core/base/version.h"

namespace {

const char* const description =
    "Covaria evaluates the measurement uncertainty of robots and large-scale metrology.\n"
    "A project (*.covaria) describes artefacts, instruments, robots and analyses; Covaria propagates their\n"
    "uncertainties (law of propagation and Monte Carlo) and writes results, pictures and a report.\n"
    "Without a subcommand the window opens.";

const char* const footer =
    "Examples:\n"
    "  covaria projects/stewart-platform.covaria\n"
    "  covaria run projects/stewart-platform.covaria --out out\n"
    "  covaria report projects/stewart-platform.covaria --format pdf\n"
    "  covaria render projects/stewart-platform.covaria --group \"pose 13\" --view top -o top.png\n"
    "  covaria export projects/lsm-network.covaria --as points -o targets.txt\n"
    "  covaria verify-report report.pdf\n"
    "  covaria validate my.covaria\n"
    "  covaria describe pose-from-points\n"
    "\n"
    "Exit status: 0 success, 1 bad input or something without results, 2 wrong usage, 3 a requirement is not "
    "met (check), 130 interrupted.";

}  // namespace

int main(int argc, char** argv) {
    using namespace covaria;
    show_control_characters();
    CLI::App app(description, "covaria");
    app.footer(footer);
    app.set_version_flag("--version", std::string("covaria ") + version());
    app.require_subcommand(0, 1);
    std::string file;
    app.add_option("FILE", file, "project file, or report (PDF) that carries one, to open in the window")
        ->check(CLI::ExistingFile);
    std::string language;
    app.add_option("--language", language, "of the window, this time: " + languages_of_window())
        ->check(
            CLI::Validator([](const std::string& code) { return complaint_about_language(code); }, "CODE"));
    const std::vector<Command> commands = all_commands(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        if (problem.get_exit_code() == 0) {  // help was asked for, or the version
            app.exit(problem);
            return all_is_printed() ? exit_success : exit_bad_input;
        }
        const std::string wrong = what_does_not_exist(app, argc, argv);
        if (wrong.empty())
            app.exit(problem);
        else
            std::fprintf(stderr, "%s\n", wrong.c_str());
        return exit_wrong_usage;
    }
    // Whatever is still thrown ends in a sentence.
    const auto status = guarded([&]() -> int {
        if (app.get_subcommands().empty()) return run_window(file, language);
        const Interrupt interrupt;
        for (const Command& command : commands)
            if (command.parser->parsed()) return command.run(interrupt.token());
        return exit_wrong_usage;
    });
    if (!status) print_error(status.error());
    const bool printed = all_is_printed();
    return status && (printed || *status != exit_success) ? *status : exit_bad_input;
}
