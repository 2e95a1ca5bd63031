// covaria export FILE: evaluates a project and writes its results as a file for other programs.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/in_quotes.h"
#include "core/setup/message_text.h"
#include "core/writers/writers.h"

namespace covaria {
namespace {

struct ExportArguments {
    RunRequest request;
    std::string writer, output;
};

std::string list_of_writers() {
    std::string text = "Writers:\n";
    std::size_t width = 0;
    for (const Writer& writer : writer_registry()) width = std::max(width, writer.name.size() + 1);
    for (const Writer& writer : writer_registry())
        text += "  " + writer.name + std::string(width - writer.name.size(), ' ') + writer.title + " (" +
                writer.ending + "): " + writer.writes + "\n";
    return text;
}

Result<const Writer*> chosen_writer(const std::string& name) {
    if (const Writer* writer = find_writer(name)) return writer;
    std::vector<std::string> names;
    for (const Writer& writer : writer_registry()) names.push_back(writer.name);
    return fail(ErrorCode::usage, "there is no writer " + in_quotes(name) + did_you_mean(name, names) +
                                      "; there are " + listed(names));
}

/// Prints what the project lacks before anything is computed. Error: it lacks something.
Result<void> check_nothing_missing(const Writer& writer, const Project& project) {
    const Problems missing = writer.missing ? writer.missing(project) : Problems();
    print_problems(missing);
    if (!missing.has_errors()) return {};
    return fail(ErrorCode::bad_input,
                writer.title + ": what it must state is missing (above); nothing was written");
}

Result<void> export_results(ExportArguments& arguments, const std::stop_token& stop) {
    const auto writer = chosen_writer(arguments.writer);
    if (!writer) return fail(writer.error());
    auto opened = open_project(arguments.request.file, arguments.request.values, arguments.request.analyses);
    if (!opened) return fail(opened.error());
    if (auto checked = check_nothing_missing(**writer, (*opened)->project()); !checked) return checked;
    const std::filesystem::path file(arguments.output);
    if (file.has_parent_path())
        if (auto made = make_output_folder(file.parent_path()); !made) return made;
    arguments.request.studies = false;  // no writer has a place for them
    auto evaluation = evaluate_analyses(*opened, arguments.request, stop);
    if (!evaluation) return fail(evaluation.error());
    auto written = (*writer)->write({*evaluation->made, evaluation->analyses});
    if (!written) return fail(written.error());
    if (auto saved = write_file_atomically(file, written->bytes); !saved) return saved;
    for (const std::string& line : written->said) std::printf("%s\n", line.c_str());
    std::printf("%s was written\n", arguments.output.c_str());
    return check_complete(*evaluation);
}

}  // namespace

Command export_command(CLI::App& app) {
    auto arguments = std::make_shared<ExportArguments>();
    CLI::App* command =
        app.add_subcommand("export", "Evaluate a project; write its results as a file for other programs");
    add_examples(
        *command,
        {{"export projects/lsm-network.covaria --as points -o targets.txt"},
         {"export projects/certificate-gauge-block.covaria --as dcc -o certificate.xml"},
         {"export projects/gum/h1-end-gauge.covaria --as xlsx -o budget.xlsx", "with live formulas"}},
        list_of_writers());
    add_run_options(*command, arguments->request);
    command->add_option("--as", arguments->writer, "what to write, see below")
        ->type_name("WRITER")
        ->required();
    command->add_option("-o,--output", arguments->output, "file to write")->type_name("FILE")->required();
    return {command, [arguments](const std::stop_token& stop) -> int {
                const auto done = export_results(*arguments, stop);
                if (done) return exit_success;
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
