// covaria import FILE: what a file of others becomes in a project, shown or written.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands/commands.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/extended_project.h"
#include "app/frozen_joints.h"
#include "app/terminal.h"
#include "core/base/in_quotes.h"
#include "core/made/import_reading.h"
#include "core/made/load_project.h"
#include "core/readers/proposal_text.h"
#include "core/readers/readers.h"
#include "core/readers/text_encoding.h"
#include "core/readers/unstated_units.h"
#include "core/setup/message_text.h"

namespace covaria {
namespace {

namespace fs = std::filesystem;

struct FileImport {
    std::string file, reader, sheet, output;
    std::vector<std::string> columns, units, cells;
    std::vector<int> rows_left_out;
    std::string tip;
    std::vector<std::string> frozen;
    bool list = false, add = false;
};

tl::unexpected<Error> with_file(Error error, const std::string& file) {
    if (error.file.empty()) error.file = file;
    return fail(std::move(error));
}

std::vector<std::string> reader_names() {
    std::vector<std::string> names;
    for (const Reader& reader : reader_registry()) names.push_back(reader.name);
    return names;
}

Result<const Reader*> chosen_reader(const FileImport& request, const std::string& text) {
    const std::string file_name = fs::path(request.file).filename().string();
    auto found = reader_for(text, file_name);
    // Stated columns mean a table, whatever else the bytes may be.
    const bool table = !request.columns.empty() && !(found && (*found)->table);
    const std::string name = request.reader.empty() && table ? "points" : request.reader;
    if (!name.empty()) {
        if (const Reader* reader = find_reader(name)) return reader;
        return fail(ErrorCode::usage, "there is no reader " + in_quotes(name) +
                                          did_you_mean(name, reader_names()) +
                                          "; \"covaria import --list\" lists them");
    }
    if (!found)
        return fail(found.error().code,
                    request.file + ": " + found.error().message + " (--as READER; --list lists them)");
    return *found;
}

Result<ReadChoice> choice_of(const FileImport& request) {
    ReadChoice choice{.file_name = fs::path(request.file).filename().string(),
                      .length_unit = {},
                      .units = {},
                      .columns = request.columns,
                      .sheet = request.sheet,
                      .chosen = !request.reader.empty(),
                      .rows_left_out = {request.rows_left_out.begin(), request.rows_left_out.end()},
                      .robot = {},
                      .beside = neighbours_of(request.file)};
    for (const std::string& cell : request.cells) {
        const std::size_t sign = cell.find('=');
        if (sign == std::string::npos || sign == 0)
            return fail(ErrorCode::usage, "--cell " + cell + ": it must be PLACE=TEXT, such as D7=mm");
        choice.cells.insert_or_assign(cell.substr(0, sign), cell.substr(sign + 1));
    }
    auto robot = urdf_choice(request.tip, request.frozen);
    if (!robot) return fail(robot.error());
    choice.robot = *std::move(robot);
    for (const std::string& text : request.units) {
        const std::size_t sign = text.rfind('=');
        const bool lengths = sign == std::string::npos;
        const auto unit = Unit::parse(lengths ? text : text.substr(sign + 1));
        if (!unit || (lengths && unit->dimension() != Unit::of("m").dimension()))
            return fail(ErrorCode::usage, "--unit " + text +
                                              (lengths ? ": it must be a length (mm, m, in), or NAME=UNIT"
                                                       : ": " + unit.error().message));
        if (lengths)
            choice.length_unit = *unit;
        else
            choice.units.insert_or_assign(text.substr(0, sign), *unit);
    }
    return choice;
}

/// Checked as `covaria validate` would, before anything is written.
Result<void> write_project(const FileImport& request, Proposals proposals) {
    auto project = project_to_extend(request.output, proposals.title);
    if (!project) return fail(project.error());
    const std::size_t assets = project->assets.size(), analyses = project->analyses.size();
    add_to_project(*project, std::move(proposals));
    const LoadedProject made =
        parse_project(project_text(*project), project_folder(request.output), request.output);
    print_problems(made.problems);
    if (made.problems.has_errors())
        return fail(ErrorCode::bad_input,
                    request.file + ": what it says contradicts itself (above); nothing was written");
    auto saved = save_project(*project, request.output);
    if (!saved) return saved;
    std::printf("\n%s:", request.output.c_str());
    for (std::size_t i = assets; i < project->assets.size(); ++i)
        std::printf(" asset \"%s\"", project->assets[i].id.c_str());
    for (std::size_t i = analyses; i < project->analyses.size(); ++i)
        std::printf(" analysis \"%s\"", project->analyses[i].id.c_str());
    std::printf("\n");
    return {};
}

Result<void> import_file(const FileImport& request) {
    std::error_code ignored;
    if (!request.output.empty() && !request.add && fs::exists(request.output, ignored))
        return fail(ErrorCode::bad_input,
                    request.output + " exists already: --add adds to it, nothing is overwritten");
    const auto choice = choice_of(request);
    if (!choice) return fail(choice.error());
    auto text = read_file(request.file);
    if (!text) return fail(text.error());
    text = text_for_readers(std::move(*text));
    const auto reader = chosen_reader(request, *text);
    if (!reader) return fail(reader.error());
    if (!(*reader)->mends_cells && !(choice->cells.empty() && choice->rows_left_out.empty()))
        return fail(ErrorCode::usage, "--cell and --leave-out are for workbooks (*.xlsx)");
    auto proposals = read_proposals(**reader, *text, *choice);
    if (!proposals && proposals.error().code == ErrorCode::usage)
        proposals.error().message += " (--columns NAME,NAME,..., --sheet NAME or --as READER)";
    else if (!proposals && (*reader)->mends_cells && proposals.error().line > 0)
        proposals.error().message +=
            " (--cell PLACE=TEXT reads a cell as TEXT, --leave-out ROW leaves a row out)";
    if (!proposals) return with_file(proposals.error(), request.file);
    if (auto checked = check_stated_units(*choice, *proposals); !checked)
        return with_file(checked.error(), request.file);
    std::fputs(text_of(**reader, *proposals, request.output.empty()).c_str(), stdout);
    if (request.output.empty()) {
        std::printf("\nNothing was written; -o PROJECT writes it.\n");
        return {};
    }
    return write_project(request, std::move(*proposals));
}

}  // namespace

Command import_command(CLI::App& app) {
    auto request = std::make_shared<FileImport>();
    CLI::App* command = app.add_subcommand(
        "import", "Read points, certificates and measurements from files of other programs");
    add_examples(*command,
                 {{"import --list", "the readers"},
                  {"import certificate.xml", "what would be taken over"},
                  {"import jig.txt --as spatialanalyzer -o jig.covaria"},
                  {"import projects/excel-budget.xlsx -o budget.covaria"},
                  {"import points.csv --unit m --columns name,x,y,z,u,- -o jig.covaria --add"},
                  {"import arm.urdf -o arm.covaria", "a robot"}},
                 "What a file does not say is asked for, and what is not taken over is listed.");
    command->add_option("FILE", request->file, "file to read");
    command->add_flag("--list", request->list, "list the readers");
    command->add_option("--as", request->reader, "read it with this reader; found without it")
        ->type_name("READER");
    command->add_option("--output,-o", request->output, "project to write; without it the content is shown")
        ->type_name("PROJECT");
    command->add_flag("--add", request->add, "add to the project if it is there already");
    command
        ->add_option("--unit", request->units,
                     "unit of lengths that bear none (mm); NAME=UNIT of a quantity that bears none, "
                     "angles=UNIT; may be repeated")
        ->type_name("UNIT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--sheet", request->sheet, "sheet of a workbook")->type_name("NAME");
    command->add_option("--cell", request->cells, "read a cell of a workbook as TEXT: D7=mm; may be repeated")
        ->type_name("PLACE=TEXT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        ->add_option("--leave-out", request->rows_left_out, "leave out a row of a workbook; may be repeated")
        ->type_name("ROW")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        ->add_option(
            "--columns", request->columns,
            "what stands in each column of a table of points: name,x,y,z,u_x,u_y,u_z,-; of a budget: "
            "quantity,value,unit,U,divisor,c,-; ? is as its head says")
        ->type_name("NAMES")
        ->delimiter(',')
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_robot_options(*command, request->tip, request->frozen);
    return {command, [request](const std::stop_token&) -> int {
                if (request->list) {
                    std::fputs(list_of_readers().c_str(), stdout);
                    return exit_success;
                }
                if (request->file.empty()) {
                    print_message("FILE is required (or --list)");
                    return exit_wrong_usage;
                }
                const auto done = import_file(*request);
                if (done) return exit_success;
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
