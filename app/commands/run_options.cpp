#include "app/commands/run_options.h"

#include <CLI/CLI.hpp>
#include <string>

#include "app/whole_number.h"

namespace covaria {
namespace {

VarianceReduction reduction_of(const std::string& key) {
    for (const auto reduction : {VarianceReduction::control_variate, VarianceReduction::sobol})
        if (key == key_of(reduction)) return reduction;
    return VarianceReduction::none;
}

}  // namespace

void add_method_options(CLI::App& command, RunRequest& request) {
    auto* trials =
        command.add_option("--trials", request.trials, "Monte Carlo with this number of trials (1e6)")
            ->type_name("N")
            ->check(CLI::Range(std::uint64_t{2}, std::uint64_t{1'000'000'000'000}));
    takes_whole_number(trials);
    auto* adaptive =
        command.add_flag("--adaptive", request.adaptive, "adaptive Monte Carlo (JCGM 101 7.9, JCGM 102 7.8)");
    auto* first =
        command.add_flag("--first-order", request.first_order, "law of propagation of uncertainty only");
    adaptive->excludes(trials);
    first->excludes(trials)->excludes(adaptive);
    command
        .add_option_function<std::string>(
            "--variance-reduction",
            [&request](const std::string& key) { request.variance_reduction = reduction_of(key); },
            "of Monte Carlo: none, control-variate or sobol")
        ->type_name("KIND")
        ->check(CLI::IsMember({"none", "control-variate", "sobol"}));
    takes_whole_number(
        command.add_option("--seed", request.seed, "seed of the random draws")->type_name("S"));
    add_threads_option(command, request.threads);
}

void add_threads_option(CLI::App& command, int& threads) {
    takes_whole_number(
        command.add_option("--threads", threads, "number of threads (results do not depend on it)")
            ->type_name("T")
            ->check(CLI::Range(0, 1024)));
}

void add_run_options(CLI::App& command, RunRequest& request) {
    command.add_option("FILE", request.file, "project file (*.covaria)")->required();
    command
        .add_option("--analysis", request.analyses,
                    "evaluate only the analysis with this id (may be repeated)")
        ->type_name("ID");
    add_method_options(command, request);
    command
        .add_option("--set", request.values,
                    "a value of the project file, for this run: /assets/0/setup/temperature=23.5 (may be "
                    "repeated; lists "
                    "are also entered by id, tables by first cell and column)")
        ->type_name("PLACE=VALUE")
        ->allow_extra_args(false);
    command.add_flag("!--no-studies", request.studies, "leave the studies (sweeps and maps) out");
}

}  // namespace covaria
