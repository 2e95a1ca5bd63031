// covaria seen FILE: what the residuals say about the uncertainties that a project states.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/evaluation.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/json_output.h"
#include "app/terminal.h"
#include "core/document/document_writers.h"
#include "core/result_files/seen_json.h"
#include "core/views/seen_table.h"

namespace covaria {
namespace {

struct SeenArguments {
    std::string file;
    std::vector<std::string> analyses, values;
    double level = 0.05;
    bool json = false;
};

struct SeenAnalysis {
    const AnalysisEntry* entry = nullptr;
    std::shared_ptr<const evidence::RedundantReadings> readings;
    evidence::Seen seen;
};

std::vector<SeenAnalysis> see_all(const MadeProject& made, const SeenArguments& arguments) {
    std::vector<SeenAnalysis> all;
    for (const AnalysisEntry& entry : made.project().analyses) {
        const bool asked = arguments.analyses.empty() ||
                           std::ranges::find(arguments.analyses, entry.id) != arguments.analyses.end();
        const auto prepared = asked ? made.analysis(entry.id) : nullptr;
        if (!prepared || !prepared->model) continue;
        if (auto readings = prepared->model->redundant_readings())
            all.push_back({&entry, readings, evidence::see(*readings, arguments.level)});
    }
    return all;
}

void print_tables(const Project& project, const std::vector<SeenAnalysis>& all) {
    ReportDocument document;
    document.title = project.title;
    for (const SeenAnalysis& one : all) {
        document.blocks.push_back(HeadingBlock{2, one.entry->name});
        document.blocks.push_back(TableBlock{seen_table(*one.readings, one.seen)});
    }
    std::fputs(to_markdown(document).c_str(), stdout);
}

void print_json(const std::vector<SeenAnalysis>& all, double level) {
    OrderedJson json = json_document("covaria-seen");
    json["level"] = level;
    json["analyses"] = OrderedJson::array();
    for (const SeenAnalysis& one : all) {
        OrderedJson analysis = {{"id", one.entry->id}, {"name", one.entry->name}};
        analysis.update(seen_json(*one.readings, one.seen));
        json["analyses"].push_back(std::move(analysis));
    }
    std::fputs(json_text(json).c_str(), stdout);
}

/// Whether the data contradict no stated figure.
Result<bool> see(const SeenArguments& arguments) {
    auto opened = open_project(arguments.file, arguments.values, arguments.analyses);
    if (!opened) return fail(opened.error());
    const std::vector<SeenAnalysis> all = see_all(**opened, arguments);
    if (all.empty()) return fail(ErrorCode::not_found, "no analysis has redundant readings");
    if (arguments.json)
        print_json(all, arguments.level);
    else
        print_tables((*opened)->project(), all);
    return std::ranges::none_of(all, [](const SeenAnalysis& one) {
        return std::ranges::any_of(one.seen.figures, evidence::is_contradicted);
    });
}

}  // namespace

Command seen_command(CLI::App& app) {
    auto arguments = std::make_shared<SeenArguments>();
    CLI::App* command = app.add_subcommand(
        "seen", "Hold stated uncertainties against the residuals; status 3 if one is contradicted");
    add_examples(*command, {{"seen projects/er10l-c10.covaria", "each stated figure, one a line"},
                            {"seen projects/er10l-c10.covaria --level 0.01 --json", "for programs"}});
    command->add_option("FILE", arguments->file, "project file (*.covaria)")->required();
    command->add_option("--analysis", arguments->analyses, "only the analysis with this id (may be repeated)")
        ->type_name("ID")
        ->allow_extra_args(false);
    command->add_option("--level", arguments->level, "level of each verdict, two-sided; 0.05 without it")
        ->check(CLI::Range(1e-6, 0.5));
    add_json_option(*command, arguments->json);
    command->add_option("--set", arguments->values, "a value of the project file, for this run, as of run")
        ->type_name("PLACE=VALUE")
        ->allow_extra_args(false);
    return {command, [arguments](const std::stop_token&) {
                const auto agrees = see(*arguments);
                if (!agrees) {
                    print_error(agrees.error());
                    return exit_status_of(agrees.error());
                }
                return int(*agrees ? exit_success : exit_not_met);
            }};
}

}  // namespace covaria
