#include "app/evaluation.h"

#include "app/terminal.h"
#include "core/project/project_file.h"
#include "core/result/representation.h"
#include "core/study/study.h"

namespace covaria {
namespace {

EvaluationOptions overridden(EvaluationOptions options, const RunRequest& request) {
    if (request.trials) {
        options.method = Method::monte_carlo;
        options.trials = *request.trials;
    }
    if (request.adaptive) options.method = Method::adaptive;
    if (request.first_order) options.method = Method::first_order;
    if (request.seed) options.seed = *request.seed;
    return options;
}

/// The project as the command line wants it evaluated; the fingerprint then covers the changes too.
Project with_overrides(Project project, const RunRequest& request) {
    for (AnalysisEntry& analysis : project.analyses) {
        analysis.options = overridden(analysis.options, request);
        for (Study& study : analysis.studies)
            if (request.first_order) study.method = Method::first_order;
    }
    return project;
}

Result<std::vector<std::string>> selected(const Project& project, const std::vector<std::string>& wanted) {
    std::vector<std::string> ids;
    for (const AnalysisEntry& analysis : project.analyses) ids.push_back(analysis.id);
    if (wanted.empty()) return ids;
    for (const std::string& id : wanted) {
        if (project.find_analysis(id)) continue;
        std::string known;
        for (const std::string& other : ids) known += (known.empty() ? "" : ", ") + other;
        return fail(ErrorCode::not_found, "there is no analysis \"" + id + "\"; the project has: " + known);
    }
    return wanted;
}

Result<EvaluatedAnalysis> evaluate_one(const Project& project, const AssetLibrary& assets,
                                       const std::string& id, const RunControl& control) {
    Problems problems;
    auto prepared = prepare_analysis(project, id, assets, problems);
    if (!prepared) {
        print_problems(problems);
        return fail(ErrorCode::bad_input, "analysis \"" + id + "\" cannot be evaluated");
    }
    if (!prepared->forecast.empty()) print_message(id + ": " + prepared->forecast);
    auto result = run_analysis(*prepared, control);
    if (!result) return fail(result.error());
    EvaluatedAnalysis evaluated{prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}};
    for (const Problem& problem : problems.items()) evaluated.warnings.push_back(problem.message);
    return evaluated;
}

Result<void> evaluate_studies(const Project& project, const AssetLibrary& assets, const RunRequest& request,
                              const std::stop_token& stop, EvaluatedAnalysis& evaluated) {
    const std::string& id = evaluated.analysis->id;
    for (const Study& study : project.find_analysis(id)->studies) {
        if (!request.study.empty() && study.id != request.study) continue;
        Problems problems;
        const auto prepared = prepare_study(project, id, study.id, assets, problems);
        if (!prepared) {
            print_problems(problems);
            return fail(ErrorCode::bad_input, "study \"" + study.id + "\" cannot be evaluated");
        }
        const std::string what = "study " + id + "/" + study.id;
        auto result = run_study(*prepared, {stop, progress_line(what), request.threads});
        end_progress_line();
        if (!result) return fail(result.error());
        if (const std::size_t failed = result->failed(); failed > 0)
            print_message(what + ": warning: " + std::to_string(failed) + " of " +
                          std::to_string(result->points.size()) +
                          " grid points have no values: " + result->reasons[1]);
        if (const std::size_t count = not_representing(*result).size(); count > 0)
            print_message(what + ": warning: what is given for " + std::to_string(count) + " of " +
                          std::to_string(result->points.size()) + " grid points " + does_not_represent +
                          ": more than 1 % of the trials have no value");
        evaluated.studies.push_back(std::make_shared<const StudyResult>(std::move(*result)));
    }
    return {};
}

}  // namespace

Result<OpenedProject> open_project(const std::string& file) {
    LoadedProject loaded = load_project(file);
    print_problems(loaded.problems);
    if (loaded.problems.has_errors())
        return fail(ErrorCode::bad_input, file + ": the project has errors; nothing was computed");
    Problems asset_problems;
    AssetLibrary assets = make_assets(loaded.project, asset_problems);
    return OpenedProject{std::move(loaded.project), std::move(assets)};
}

Result<std::vector<EvaluatedAnalysis>> evaluate_analyses(const OpenedProject& opened,
                                                         const RunRequest& request,
                                                         const std::stop_token& stop) {
    const Project project = with_overrides(opened.project, request);
    const auto ids = selected(project, request.analyses);
    if (!ids) return fail(ids.error());
    std::vector<EvaluatedAnalysis> evaluated;
    for (const std::string& id : *ids) {
        const RunControl control{stop, progress_line("analysis " + id), request.threads};
        auto one = evaluate_one(project, opened.assets, id, control);
        end_progress_line();
        if (!one) return fail(one.error());
        for (const std::string& warning : one->result->warnings) print_message(id + ": warning: " + warning);
        if (request.studies)
            if (auto done = evaluate_studies(project, opened.assets, request, stop, *one); !done)
                return fail(done.error());
        evaluated.push_back(std::move(*one));
    }
    return evaluated;
}

}  // namespace covaria
