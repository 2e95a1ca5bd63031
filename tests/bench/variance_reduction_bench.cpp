// Trials and time to a standard error of u/1000 at the interval ends: plain, with control variates, with
// Sobol points. Prints a table in Markdown. Times are of the processor, on one thread.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>
#include <string>

#include "core/base/resource_path.h"
#include "core/propagation/draw_plan.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace {

using namespace covaria;

struct Case {
    const char* title;
    const char* project;
    const char* analysis;
    std::size_t poses;  ///< rows taken of the table "poses"; 0: all
};

constexpr Case cases[] = {
    {"one pose (Stewart platform)", "projects/stewart-platform.covaria", "printed", 1},
    {"13 poses (Stewart platform)", "projects/stewart-platform.covaria", "printed", 13},
    {"tool centre point, ballbars", "projects/ballbar-tcp.covaria", "paper", 0},
    {"network of sensors", "projects/lsm-network.covaria", "recommended", 0},
    {"pose of a robot", "projects/er10l-c10.covaria", "zero-pose", 0},
    {"force and moment, loads", "projects/force-moment-sensor.covaria", "loads", 0},
    {"JCGM 101 9.3, mass", "projects/gum/s1-9.3-mass.covaria", "mass", 0},
    {"JCGM 101 9.4, x1 = 0", "projects/gum/s1-9.4-power-meter.covaria", "x000-r0", 0},
    {"JCGM 101 9.4, x1 = 0.050", "projects/gum/s1-9.4-power-meter.covaria", "x050-r0", 0},
    {"JCGM 101 9.5, gauge block", "projects/gum/s1-9.5-gauge-block.covaria", "gauge-block", 0},
};

std::shared_ptr<const PreparedAnalysis> prepared(const Case& of) {
    Project project = load_project(data_directory() / of.project).project;
    for (AnalysisEntry& entry : project.analyses)
        if (entry.id == of.analysis && of.poses > 0)
            std::get<SetupTable>(entry.setup.values.at("poses")).rows.resize(of.poses);
    Problems problems;
    return made_analysis(project, of.analysis, problems);
}

double processor_seconds(const std::function<void()>& work) {
    timespec before{}, after{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
    work();
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
    return double(after.tv_sec - before.tv_sec) + 1e-9 * double(after.tv_nsec - before.tv_nsec);
}

constexpr std::uint64_t trials = 1'000'000;
constexpr int repetitions = 3;  // the least time of them
constexpr double goal = 1e-3;   // part of u

/// The cost of trials, for the figure of the measurands that needs most.
struct Cost {
    double seconds_per_trial = 0.0;
    double end_error = 0.0, plain_end_error = 0.0;  ///< at `trials`, in u
    double u_gain = infinity;
    double trials_needed(double error) const { return double(trials) * std::pow(error / goal, 2); }
};

Cost cost_of(const PreparedAnalysis& analysis, VarianceReduction reduction) {
    EvaluationOptions options;
    options.coverage_probability = analysis.options.coverage_probability;
    options.trials = trials;
    options.variance_reduction = reduction;
    std::optional<UncertaintyResult> result;
    Cost cost;
    cost.seconds_per_trial = infinity;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        const double seconds = processor_seconds([&] {
            result = *evaluate(*analysis.model, analysis.inputs, options, {{}, {}, 1});
        });
        cost.seconds_per_trial = std::min(cost.seconds_per_trial, seconds / double(trials));
    }
    for (const OutputResult& output : result->outputs) {
        if (output.quantity.role != OutputRole::measurand || !output.monte_carlo->reduced) continue;
        const ReducedVariance& reduced = *output.monte_carlo->reduced;
        const double u = output.standard_uncertainty;
        const auto take = [&](double error, double gain) {
            cost.end_error = std::max(cost.end_error, error / u);
            cost.plain_end_error = std::max(cost.plain_end_error, error * std::sqrt(gain) / u);
        };
        take(reduced.standard_errors.low, reduced.gains.low);
        take(reduced.standard_errors.high, reduced.gains.high);
        cost.u_gain = std::min(cost.u_gain, reduced.gains.standard_uncertainty);
    }
    return cost;
}

double draw_seconds_per_trial(const PreparedAnalysis& analysis) {
    const auto correlations = resolved_correlations(analysis.inputs);
    const detail::DrawPlan plan(analysis.inputs, *correlations);
    detail::TrialRows rows(plan.quantities());
    detail::DrawWorkspace workspace(plan.latent_rows());
    constexpr std::uint64_t blocks = 100;
    double least = infinity;
    for (int repetition = 0; repetition < repetitions; ++repetition)
        least =
            std::min(least, processor_seconds([&] {
                         for (std::uint64_t b = 0; b < blocks; ++b)
                             plan.draw(1, b * detail::block_trials, detail::block_trials, rows, workspace);
                     }));
    return least / double(blocks * detail::block_trials);
}

void print_cell(const Cost& cost, double needed) {
    std::printf(" %.2g | %.2g |", needed, needed * cost.seconds_per_trial);
}

void print_row(const Case& of) {
    const auto analysis = prepared(of);
    const Cost plain = cost_of(*analysis, VarianceReduction::none);
    const Cost control = cost_of(*analysis, VarianceReduction::control_variate);
    const Cost sobol = cost_of(*analysis, VarianceReduction::sobol);
    std::printf("| %s |", of.title);
    print_cell(plain, control.trials_needed(control.plain_end_error));
    print_cell(control, control.trials_needed(control.end_error));
    print_cell(sobol, sobol.trials_needed(sobol.end_error));
    std::printf(" %.3g | %.3g | %.2g | %.2g |\n", std::pow(control.plain_end_error / control.end_error, 2),
                control.u_gain, control.seconds_per_trial / plain.seconds_per_trial,
                control.seconds_per_trial / draw_seconds_per_trial(*analysis));
    std::fflush(stdout);
}

}  // namespace

int main() {
    std::printf(
        "| model | plain: trials | s | control variate: trials | s | Sobol: trials | s | gain at the ends | "
        "gain of u "
        "| time of a trial to plain | to draws alone |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Case& of : cases) print_row(of);
}
