#include "app/shared_run.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/run_options.h"
#include "core/base/guarded.h"
#include "core/propagation/engine.h"
#include "core/propagation/forecast.h"

namespace covaria {

namespace {

std::shared_ptr<const PreparedStudy> prepared(const SharedRun& run, const UnitWork& work) {
    Problems said_when_merged;
    return prepare_study(run.made, work.analysis, work.study, said_when_merged);
}

/// Batches expected of an adaptive run: half as many again as the law of propagation makes expect.
std::uint64_t expected_batches(const PreparedAnalysis& analysis) {
    constexpr double reserve = 1.5, most = 1e12;
    const auto& law = analysis.propagated->propagation();
    const auto forecast = law ? forecast_adaptive(*analysis.model, *law, analysis.options) : std::nullopt;
    const double batches =
        forecast ? forecast->batches : static_cast<double>(analysis.options.minimum_batches);
    return static_cast<std::uint64_t>(std::min(most, std::ceil(reserve * batches)));
}

void add_works(const std::string& id, SharedRun& run) {
    const auto analysis = run.made->analysis(id);
    if (!analysis) return;
    if (const std::uint64_t units = units_of_run(analysis->options); units > 0) {
        run.works.push_back({id, "", analysis->fingerprint(), units});
        if (analysis->options.method == Method::adaptive)
            run.works.back().shared = std::min(units, expected_batches(*analysis));
    }
    if (!run.request.studies) return;
    for (const Study& study : run.made->project().find_analysis(id)->studies) {
        UnitWork work{id, study.id, "", 0};
        const auto ready = prepared(run, work);
        if (!ready) continue;
        work.fingerprint = ready->fingerprint;
        work.units = work.shared = units_of_study(*ready);
        run.works.push_back(std::move(work));
    }
}

}  // namespace

PartRequest SharedRun::part_request() const {
    return {std::filesystem::absolute(request.file).lexically_normal().string(), arguments_of(request)};
}

Result<SharedRun> open_shared_run(const RunRequest& request) {
    auto opened = open_project(request.file, request.values, request.analyses);
    if (!opened) return fail(opened.error());
    SharedRun run{request, *opened, requested(*opened, request), {}};
    const auto ids = requested_analyses((*opened)->project(), request);
    if (!ids) return fail(ids.error());
    for (const std::string& id : *ids) add_works(id, run);
    return run;
}

std::vector<std::string> arguments_of(const RunRequest& request) {
    std::vector<std::string> arguments;
    const auto add = [&arguments](const char* option, const std::string& value) {
        arguments.insert(arguments.end(), {option, value});
    };
    for (const std::string& id : request.analyses) add("--analysis", id);
    if (request.trials) add("--trials", std::to_string(*request.trials));
    if (request.adaptive) arguments.push_back("--adaptive");
    if (request.first_order) arguments.push_back("--first-order");
    if (request.variance_reduction)
        add("--variance-reduction", std::string(key_of(*request.variance_reduction)));
    if (request.seed) add("--seed", std::to_string(*request.seed));
    for (const std::string& value : request.values) add("--set", value);
    if (!request.studies) arguments.push_back("--no-studies");
    return arguments;
}

Result<RunRequest> request_of(const PartRequest& part, const std::string& project) {
    RunRequest request;
    CLI::App parser;
    add_run_options(parser, request);
    std::vector<std::string> arguments = part.arguments;
    arguments.push_back(project.empty() ? part.project : project);
    std::reverse(arguments.begin(), arguments.end());
    try {
        parser.parse(arguments);
    } catch (const CLI::ParseError& problem) {
        return fail(ErrorCode::bad_input,
                    std::string("the parts were made with options that are not known: ") + problem.what());
    }
    return request;
}

Result<void> compute_units(const SharedRun& run, const UnitWork& work, UnitStore& store,
                           const std::stop_token& stop) {
    const RunControl control{stop, {}, run.request.threads, &store};
    const auto outcome = [](const auto& result) -> Result<void> {
        if (!result) return fail(result.error());
        return {};
    };
    const auto done = guarded([&]() -> Result<void> {
        if (work.study.empty()) return outcome(run_analysis(*run.made->analysis(work.analysis), control));
        return outcome(run_study(*prepared(run, work), control));
    });
    if (!done) return fail(done.error());
    // Units were computed for others, so there is no result here.
    const bool as_asked = *done || ((*done).error().code == ErrorCode::cancelled && !stop.stop_requested());
    if (!as_asked) return fail((*done).error());
    return {};
}

UnitRange range_of_part(std::uint64_t units, std::uint64_t k, std::uint64_t n) {
    // Border of part i, without products that overflow.
    const auto border = [&](std::uint64_t i) { return units / n * i + units % n * i / n; };
    return {border(k - 1), border(k)};
}

}  // namespace covaria
