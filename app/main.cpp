// The program: a window without a subcommand, a headless tool with one.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/printed_text.h"
#include "app/terminal.h"
#include "app/window.h"
#include "core/base/guarded.h"
#include "core/base/in_quotes.h"
#include "core/base/version.h"
#include "core/setup/message_text.h"

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

/// "there is no command ..." where the first word is neither a file nor an option; else empty.
std::string mistyped_command(const CLI::App& app, int argc, char** argv) {
    const std::string word = argc > 1 ? argv[1] : "";
    std::error_code ignored;
    if (word.empty() || word.front() == '-' || std::filesystem::exists(word, ignored)) return {};
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), word) != names.end()) return {};
    const std::string hint = covaria::did_you_mean(word, names).english();
    if (hint.empty()) return {};
    return "there is no command " + covaria::in_quotes(word) + hint;
}

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
        if (const std::string wrong = mistyped_command(app, argc, argv); !wrong.empty()) {
            std::fprintf(stderr, "%s\n", wrong.c_str());
            return exit_wrong_usage;
        }
        return app.exit(problem) != 0 ? exit_wrong_usage : all_is_printed() ? exit_success : exit_bad_input;
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
