// covaria design FILE: the best values and rows that a design of the project allows.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/json_output.h"
#include "app/output_folder.h"
#include "app/terminal.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/base/in_quotes.h"
#include "core/design/design.h"
#include "core/project/project_file.h"
#include "core/result_files/csv_writer.h"
#include "core/result_files/design_json.h"
#include "core/text/numbers.h"
#include "core/views/design_results.h"

namespace covaria {
namespace {

struct DesignArguments {
    std::string file, design, analysis, out, take_over;
    std::vector<std::string> values;
    int threads = 0;
    bool json = false;
};

struct DesignPlace {
    std::string analysis, design;
};

/// The design that is asked for, or the only one.
Result<DesignPlace> find_design(const Project& project, const DesignArguments& arguments) {
    std::vector<DesignPlace> all, fitting;
    std::string known;
    for (const AnalysisEntry& analysis : project.analyses)
        for (const Design& design : analysis.designs) {
            all.push_back({analysis.id, design.id});
            known += (known.empty() ? "" : ", ") + analysis.id + "/" + design.id;
            if ((arguments.analysis.empty() || arguments.analysis == analysis.id) &&
                (arguments.design.empty() || arguments.design == design.id))
                fitting.push_back(all.back());
        }
    if (fitting.size() == 1) return fitting.front();
    if (all.empty()) return fail(ErrorCode::not_found, "no analysis of the project has designs");
    return fail(ErrorCode::not_found,
                (fitting.empty() ? "there is no such design; the project has: "
                                 : "choose one with --design and --analysis; the project has: ") +
                    known);
}

void show(const DesignPlace& place, const Progress& progress) {
    show_progress(place.analysis + "/" + place.design + ": " + std::to_string(progress.trials_done) + " of " +
                  std::to_string(progress.trials_planned) + " evaluations" +
                  (progress.best ? ", best so far " + format_significant(*progress.best, 5) : ""));
}

Result<void> write_files(const DesignArguments& arguments, const DesignResult& result) {
    if (arguments.out.empty()) return {};
    const std::filesystem::path folder = arguments.out;
    if (auto made = make_output_folder(folder); !made) return made;
    const std::string stem = "design-" + file_name_part(result.analysis) + "-" + file_name_part(result.id);
    auto written = write_file_atomically(folder / (stem + ".json"), design_json(result));
    for (const Table& table : design_tables(result))
        if (written)
            written = write_file_atomically(folder / (stem + "-" + table.id + ".csv"), to_csv(table));
    return written;
}

Result<void> write_project(const DesignArguments& arguments, const Project& project,
                           const PreparedDesign& design, const DesignResult& result) {
    if (arguments.take_over.empty()) return {};
    if (!result.found)
        return fail(ErrorCode::bad_input,
                    "there is no design to take over: nothing that was tried has a result");
    auto taken = take_over(project, design, result);
    if (!taken) return fail(taken.error());
    return save_project(*taken, arguments.take_over);
}

/// Whether the design was found and meets its targets.
Result<bool> design(const DesignArguments& arguments, const std::stop_token& stop) {
    auto opened = open_project(arguments.file, arguments.values);
    if (!opened) return fail(opened.error());
    const Project& project = (*opened)->project();
    const auto place = find_design(project, arguments);
    if (!place) return fail(place.error());
    Problems problems;
    const auto prepared = prepare_design(*opened, place->analysis, place->design, problems);
    if (!prepared) {
        print_problems(problems);
        return fail(ErrorCode::bad_input, "the design cannot be searched");
    }
    const auto result = run_design(
        *prepared, {stop, [&](const Progress& progress) { show(*place, progress); }, arguments.threads});
    end_progress_line();
    if (!result) return fail(result.error());
    std::fputs((arguments.json ? design_json(*result) : design_text(*result)).c_str(), stdout);
    if (auto written = write_files(arguments, *result); !written) return fail(written.error());
    if (auto written = write_project(arguments, project, *prepared, *result); !written)
        return fail(written.error());
    return result->met();
}

}  // namespace

Command design_command(CLI::App& app) {
    auto arguments = std::make_shared<DesignArguments>();
    CLI::App* command = app.add_subcommand(
        "design", "Find where to stand and what to measure; status 3 if a target is not met");
    add_examples(*command, {{"design projects/ballbar-design.covaria --design twelve"},
                            {"design projects/ballbar-design.covaria --take-over twelve.covaria --out design",
                             "the project with the design in it, and tables"}});
    command->add_option("FILE", arguments->file, "project file (*.covaria)")->required();
    command
        ->add_option("--design,--study", arguments->design,
                     "the design with this id; needed where there are several")
        ->type_name("ID");
    command->add_option("--analysis", arguments->analysis, "the analysis that it is of")->type_name("ID");
    command->add_option("--out", arguments->out, "folder for JSON and CSV tables")->type_name("DIR");
    command->add_option("--take-over", arguments->take_over, "write the project with the design in it")
        ->type_name("FILE");
    add_threads_option(*command, arguments->threads);
    add_json_option(*command, arguments->json);
    command->add_option("--set", arguments->values, "a value of the project file, for this run, as of run")
        ->type_name("PLACE=VALUE")
        ->allow_extra_args(false);
    return {command, [arguments](const std::stop_token& stop) {
                const auto met = design(*arguments, stop);
                if (!met) {
                    print_error(met.error());
                    return exit_status_of(met.error());
                }
                return int(*met ? exit_success : exit_not_met);
            }};
}

}  // namespace covaria
