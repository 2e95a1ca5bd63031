// The subcommands of the command line, one file each. A command registers itself on the parser and is run by
// main when the parser chose it.
//
// A new command needs a file here, a line below and one in commands.cpp.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

namespace CLI {
class App;
}

namespace covaria {

struct Command {
    CLI::App* parser = nullptr;
    std::function<int(const std::stop_token&)> run;  ///< returns the exit status
};

Command run_command(CLI::App& app);
Command part_command(CLI::App& app);
Command merge_command(CLI::App& app);
Command submit_command(CLI::App& app);
Command check_command(CLI::App& app);
Command seen_command(CLI::App& app);
Command compare_command(CLI::App& app);
Command impact_command(CLI::App& app);
Command release_command(CLI::App& app);
Command design_command(CLI::App& app);
Command report_command(CLI::App& app);
Command render_command(CLI::App& app);
Command validate_command(CLI::App& app);
Command describe_command(CLI::App& app);
Command convert_command(CLI::App& app);
Command library_command(CLI::App& app);
Command manual_command(CLI::App& app);
Command export_command(CLI::App& app);
Command import_command(CLI::App& app);
Command import_urdf_command(CLI::App& app);
Command verify_command(CLI::App& app);
Command verify_report_command(CLI::App& app);

std::vector<Command> all_commands(CLI::App& app);

}  // namespace covaria
