// covaria convert FILE: rewrites a project in the current schema version and canonical form, optionally with
// its CSV data inside.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/commands/commands.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/terminal.h"
#include "core/made/load_project.h"

namespace covaria {
namespace {

struct ConvertRequest {
    std::string file, output;
    bool embed = false;
};

void embed_tables(Setup& setup) {
    for (auto& [key, value] : setup.values)
        if (auto* table = std::get_if<SetupTable>(&value)) {
            table->csv_file.clear();
            table->csv_columns.clear();
        }
}

bool refers_to_csv(const Setup& setup) {
    for (const auto& [key, value] : setup.values)
        if (const auto* table = std::get_if<SetupTable>(&value); table && !table->csv_file.empty())
            return true;
    return false;
}

bool refers_to_csv(const Project& project) {
    for (const AssetEntry& asset : project.assets)
        if (refers_to_csv(asset.setup)) return true;
    for (const AnalysisEntry& analysis : project.analyses)
        if (refers_to_csv(analysis.setup)) return true;
    return false;
}

bool same_folder(const std::string& a, const std::string& b) {
    namespace fs = std::filesystem;
    return fs::weakly_canonical(fs::absolute(a).parent_path()) ==
           fs::weakly_canonical(fs::absolute(b).parent_path());
}

int convert(const ConvertRequest& request) {
    LoadedProject loaded = load_project(request.file);
    print_problems(loaded.problems);
    if (loaded.problems.has_errors()) return exit_bad_input;
    if (request.embed) {
        for (AssetEntry& asset : loaded.project.assets) embed_tables(asset.setup);
        for (AnalysisEntry& analysis : loaded.project.analyses) embed_tables(analysis.setup);
    } else if (refers_to_csv(loaded.project) && !same_folder(request.file, request.output)) {
        print_message(
            "the project refers to CSV files beside it, which the new folder does not have: use --embed");
        return exit_bad_input;
    }
    if (auto saved = save_project(loaded.project, request.output); !saved) {
        print_error(saved.error());
        return exit_status_of(saved.error());
    }
    return exit_success;
}

}  // namespace

Command convert_command(CLI::App& app) {
    auto request = std::make_shared<ConvertRequest>();
    CLI::App* command =
        app.add_subcommand("convert", "Write a project in the current file version and canonical form");
    add_examples(*command, {{"convert projects/stewart-platform.covaria whole.covaria --embed",
                             "its CSV files inside"}});
    command->add_option("FILE", request->file, "project file (*.covaria), of this or an older version")
        ->required();
    command->add_option("OUTPUT", request->output, "file to write; may be the same as FILE")->required();
    command->add_flag("--embed", request->embed,
                      "put the data of referenced CSV files into the project file");
    return {command, [request](const std::stop_token&) { return convert(*request); }};
}

}  // namespace covaria
