#include "app/evaluation.h"

#include <charconv>
#include <optional>
#include <set>
#include <string_view>

#include "app/terminal.h"
#include "core/base/guarded.h"
#include "core/design/design.h"
#include "core/made/certificate_gaps.h"
#include "core/made/load_project.h"
#include "core/project/project_file.h"
#include "core/project/set_values.h"
#include "core/report/certificate_warnings.h"
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
    if (request.variance_reduction) options.variance_reduction = *request.variance_reduction;
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

Message why(const Problems& problems) {
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error) return problem.path + ": " + problem.message;
    return tell<"it cannot be made">();
}

std::string words_of(const FailedAnalysis& failed) {
    const std::string name = failed.name.empty() ? "" : " (" + failed.name + ")";
    return (failed.study.empty() ? "analysis " + failed.id : "study " + failed.id + "/" + failed.study) +
           name + ": " + failed.cause.english();
}

/// "/analyses/3/..." is of the entry 3 behind `place`; nothing: of no entry there.
std::optional<std::size_t> entry_of(const std::string& path, std::string_view place) {
    if (!path.starts_with(place)) return std::nullopt;
    std::size_t index = 0;
    const char* end = path.data() + path.size();
    const auto [after, status] = std::from_chars(path.data() + place.size(), end, index);
    if (status != std::errc{} || (after != end && *after != '/')) return std::nullopt;
    return index;
}

/// Tells whether the analyses depend on the entry of a problem; they are all where none is named.
class Concern {
public:
    Concern(const MadeProject& made, const std::vector<std::string>& analyses) : graph_(made.graph()) {
        const Project& project = made.project();
        const auto first = project.analyses.data();
        for (const std::string& id : analyses) {
            const AnalysisEntry* entry = project.find_analysis(id);
            if (!entry) continue;  // an unknown id is reported later
            const std::size_t number = graph_.number_of_analysis(static_cast<std::size_t>(entry - first));
            used_.insert(number);
            const auto used = graph_.used_by(number);
            used_.insert(used.begin(), used.end());
        }
        assets_ = project.assets.size();
        analyses_ = project.analyses.size();
    }

    bool has(const Problem& problem) const {
        if (used_.empty()) return true;
        if (const auto asset = entry_of(problem.path, "/assets/"))
            return *asset >= assets_ || used_.contains(*asset);
        if (const auto analysis = entry_of(problem.path, "/analyses/"))
            return *analysis >= analyses_ || used_.contains(graph_.number_of_analysis(*analysis));
        return true;
    }

private:
    const EntryGraph& graph_;
    std::set<std::size_t> used_;
    std::size_t assets_ = 0, analyses_ = 0;
};

/// The errors of a project that keep the analyses from being evaluated.
Problems errors_of(const LoadedProject& loaded, const std::vector<std::string>& analyses) {
    Problems errors;
    if (!loaded.made) return loaded.problems;
    const Concern concern(*loaded.made, analyses);
    for (const Problem& problem : loaded.problems.items())
        if (problem.severity == Severity::error && concern.has(problem)) errors.add(problem);
    return errors;
}

/// Evaluates analysis after analysis and keeps what failed.
class Evaluator {
public:
    Evaluator(MadeProject::Pointer made, const RunRequest& request, const std::stop_token& stop,
              UnitStores* stores)
        : made_(std::move(made)), request_(request), stop_(stop), stores_(stores) {
        evaluation.made = made_;
    }

    /// Error{cancelled} only.
    Result<void> add(const std::string& id) {
        auto one = evaluate(id);
        end_progress_line();
        if (!one && one.error().code == ErrorCode::cancelled) return fail(one.error());
        if (!one) {
            note_failure(id, "", one.error().message);
            return {};
        }
        for (const Message& warning : one->result->warnings)
            print_message(id + ": warning: " + warning.english());
        auto studies = request_.studies ? evaluate_studies(*one) : Result<void>{};
        if (studies && request_.designs) studies = evaluate_designs(*one);
        evaluation.analyses.push_back(std::move(*one));
        return studies;
    }

    Evaluation evaluation;

private:
    RunControl control(const std::string& what, const std::string& id, const std::string& study) const {
        return {stop_, progress_line(what), request_.threads, stores_ ? stores_->of(id, study) : nullptr};
    }

    Result<EvaluatedAnalysis> evaluate(const std::string& id) const {
        const Problems problems = made_->problems_of_analysis(id);
        const auto prepared = made_->analysis(id);
        if (!prepared) return fail(ErrorCode::bad_input, why(problems));
        if (!prepared->forecast.empty()) print_message(id + ": " + prepared->forecast.english());
        auto result = run_analysis(*prepared, control("analysis " + id, id, ""));
        if (!result) return fail(result.error());
        EvaluatedAnalysis evaluated{
            prepared, std::make_shared<const UncertaintyResult>(std::move(*result)), {}};
        evaluated.warnings = made_->warnings_of(id);
        return evaluated;
    }

    Result<void> evaluate_studies(EvaluatedAnalysis& evaluated) {
        const std::string& id = evaluated.analysis->id;
        for (const Study& study : made_->project().find_analysis(id)->studies) {
            if (!request_.study.empty() && study.id != request_.study) continue;
            auto result = evaluate(id, study.id);
            end_progress_line();
            if (!result && result.error().code == ErrorCode::cancelled) return fail(result.error());
            if (!result)
                note_failure(id, study.id, result.error().message);
            else
                evaluated.studies.push_back(std::make_shared<const StudyResult>(std::move(*result)));
        }
        return {};
    }

    Result<StudyResult> evaluate(const std::string& id, const std::string& study) const {
        Problems problems;
        const auto prepared = prepare_study(made_, id, study, problems);
        if (!prepared) return fail(ErrorCode::bad_input, why(problems));
        const std::string what = "study " + id + "/" + study;
        auto ran = guarded([&] { return run_study(*prepared, control(what, id, study)); });
        if (!ran) return fail(ran.error());
        if (!*ran) return fail(ran->error());
        if (const std::size_t failed = (*ran)->failed(); failed > 0)
            print_message(what + ": warning: " + std::to_string(failed) + " of " +
                          std::to_string((*ran)->points.size()) +
                          " grid points have no values: " + (*ran)->reasons[1].english());
        if (const std::size_t count = not_representing(**ran).size(); count > 0)
            print_message(what + ": warning: what is given for " + std::to_string(count) + " of " +
                          std::to_string((*ran)->points.size()) + " grid points " + does_not_represent +
                          ": more than 1 % of the trials have no value");
        return std::move(**ran);
    }

    Result<void> evaluate_designs(EvaluatedAnalysis& evaluated) {
        const std::string& id = evaluated.analysis->id;
        for (const Design& design : made_->project().find_analysis(id)->designs) {
            if (!request_.design.empty() && design.id != request_.design) continue;
            Problems problems;
            const auto prepared = prepare_design(made_, id, design.id, problems);
            const std::string what = "design " + id + "/" + design.id;
            auto result = prepared ? run_design(*prepared, {stop_, progress_line(what), request_.threads})
                                   : Result<DesignResult>(fail(ErrorCode::bad_input, why(problems)));
            end_progress_line();
            if (!result && result.error().code == ErrorCode::cancelled) return fail(result.error());
            if (!result)
                note_failure(id, design.id, result.error().message);
            else
                evaluated.designs.push_back(std::make_shared<const DesignResult>(std::move(*result)));
        }
        return {};
    }

    void note_failure(const std::string& id, const std::string& study, const Message& cause) {
        FailedAnalysis failed{id, made_->project().find_analysis(id)->name, study, cause};
        print_message(words_of(failed));
        evaluation.failed.push_back(std::move(failed));
    }

    const MadeProject::Pointer made_;
    const RunRequest& request_;
    std::stop_token stop_;
    UnitStores* stores_;
};

}  // namespace

Result<MadeProject::Pointer> open_project(const std::string& file, const std::vector<std::string>& values,
                                          const std::vector<std::string>& analyses) {
    const auto places = values_at(values);
    if (!places) return fail(places.error());
    LoadedProject loaded = load_project(file, *places);
    print_problems(loaded.problems);
    if (errors_of(loaded, analyses).has_errors())
        return fail(ErrorCode::bad_input, file + ": the project has errors; nothing was computed");
    if (loaded.problems.has_errors())
        print_message("the errors are of other analyses: they keep nothing from being evaluated here");
    return loaded.made;
}

Result<Problems> errors_of_project(const std::string& file, const std::vector<std::string>& values,
                                   const std::vector<std::string>& analyses) {
    const auto places = values_at(values);
    if (!places) return fail(places.error());
    return errors_of(load_project(file, *places), analyses);
}

void say_what_is_missing(const ReportSource& source) {
    Problems missing = missing_in(source.made, ids_of(source.analyses));
    missing.take(improbable_results(source), "");
    missing.take(results_beyond_capability(source), "");
    for (Problem& problem : missing.items()) problem.severity = Severity::warning;
    print_problems(missing);
}

MadeProject::Pointer requested(const MadeProject::Pointer& opened, const RunRequest& request) {
    return MadeProject::make(with_overrides(opened->project(), request), opened);
}

Result<std::vector<std::string>> requested_analyses(const Project& project, const RunRequest& request) {
    return selected(project, request.analyses);
}

Result<Evaluation> evaluate_analyses(const MadeProject::Pointer& opened, const RunRequest& request,
                                     const std::stop_token& stop, UnitStores* stores) {
    const auto ids = requested_analyses(opened->project(), request);
    if (!ids) return fail(ids.error());
    Evaluator evaluator(requested(opened, request), request, stop, stores);
    for (const std::string& id : *ids)
        if (auto added = evaluator.add(id); !added) return fail(added.error());
    return std::move(evaluator.evaluation);
}

Result<void> compare_with(const std::string& file, RunRequest request, Evaluation& evaluation,
                          const std::stop_token& stop) {
    const auto opened = open_project(file);
    if (!opened) return fail(opened.error());
    request.studies = request.designs = false;
    request.analyses.clear();
    for (const EvaluatedAnalysis& now : evaluation.analyses)
        if ((*opened)->project().find_analysis(now.analysis->id))
            request.analyses.push_back(now.analysis->id);
    if (request.analyses.empty())
        return fail(ErrorCode::not_found, file + " has none of the analyses that are compared with it");
    const auto earlier = evaluate_analyses(*opened, request, stop);
    if (!earlier) return fail(earlier.error());
    for (const EvaluatedAnalysis& was : earlier->analyses)
        for (EvaluatedAnalysis& now : evaluation.analyses)
            if (now.analysis->id == was.analysis->id)
                now.before = std::make_shared<const ResultsBefore>(
                    ResultsBefore{file, compare_results(was.result, now.result)});
    return check_complete(*earlier);
}

Result<void> check_complete(const Evaluation& evaluation) {
    if (evaluation.failed.empty()) return {};
    std::string names;
    for (const FailedAnalysis& failed : evaluation.failed)
        names += (names.empty() ? "" : ", ") + failed.id + (failed.study.empty() ? "" : "/" + failed.study);
    return fail(ErrorCode::numeric, std::to_string(evaluation.failed.size()) + " without results: " + names);
}

}  // namespace covaria
