// covaria-mpi run FILE: covaria run on as many machines as mpirun starts it on.
#include <mpi.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <thread>

#include "app/commands/run_options.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/mpi/exchange.h"
#include "app/output_folder.h"
#include "app/printed_text.h"
#include "app/terminal.h"
#include "app/wrong_usage.h"
#include "core/base/guarded.h"
#include "core/base/version.h"
#include "core/result_files/result_files.h"

namespace {

using namespace covaria;

struct Arguments {
    RunRequest request;
    std::string journal = "parts";
    std::string out = "out";
    bool resume = false;
};

/// Number of ranks that a unit may end before it is not tried any more.
constexpr int most_ends = 3;

std::string replay_of(const SharedRun& run, const std::string& analysis, std::uint64_t unit) {
    std::string line = "covaria part " + run.part_request().project;
    for (const std::string& argument : run.part_request().arguments) line += " " + argument;
    const bool chosen = run.request.analyses.size() == 1;
    return line + (chosen ? "" : " --analysis " + analysis) + " --unit " + std::to_string(unit + 1);
}

std::string name_of(const DeadlyUnit& unit) {
    return "unit " + std::to_string(unit.unit + 1) + " of \"" + unit.analysis +
           (unit.study.empty() ? "" : "/" + unit.study) + "\"";
}

/// The journal as earlier runs left it, and the units that ended a rank of them.
struct Journal {
    std::unique_ptr<PartsFolder> folder;
    std::vector<DeadlyUnit> deadly;
};

Result<Journal> open_journal(const Arguments& arguments, const SharedRun& run) {
    if (auto made = make_output_folder(arguments.journal); !made) return fail(made.error());
    auto folder = PartsFolder::open(arguments.journal);
    if (!folder) return fail(folder.error());
    if (!(*folder)->empty() && !arguments.resume)
        return fail(ErrorCode::usage, arguments.journal +
                                          ": there are parts in this folder: go on with them (--resume), or "
                                          "name another one (--journal)");
    if (auto same = (*folder)->check(run.works); !same) return fail(same.error());
    auto deadly = counted_deadly_units(arguments.journal);
    if (!deadly) return fail(deadly.error());
    std::erase_if(*deadly, [&](const DeadlyUnit& unit) {
        return (*folder)->has({unit.analysis, unit.study, "", 0}, unit.unit);
    });
    for (const DeadlyUnit& unit : *deadly)
        if (unit.times >= most_ends)
            return fail(ErrorCode::numeric, name_of(unit) + " has ended the process that computed it " +
                                                std::to_string(unit.times) + " times. To see why: " +
                                                replay_of(run, unit.analysis, unit.unit));
    return Journal{*std::move(folder), *std::move(deadly)};
}

/// Stopped from outside: by the user, or because another rank was ended. Says which units that was about.
void say_what_was_ended(const Arguments& arguments, const SharedRun& run) {
    // The others take their notes back meanwhile.
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    for (const DeadlyUnit& unit : left_units(arguments.journal))
        print_message("a process was ended while it computed " + name_of(unit) +
                      ". --resume goes on; to compute it alone: " + replay_of(run, unit.analysis, unit.unit));
}

Result<void> lead(const Arguments& arguments, const SharedRun& run, Journal& journal, int ranks,
                  const std::stop_token& stop) {
    HandingOut source(run, *journal.folder, ranks, std::move(journal.deadly), stop);
    const MissingUnits missing{MissingUnits::Rule::compute, ranks > 1 ? &source : nullptr};
    const auto evaluation = merge_units(run, *journal.folder, missing, stop);
    if (source.problem()) return fail(*source.problem());
    if (stop.stop_requested()) say_what_was_ended(arguments, run);
    if (!evaluation) return fail(evaluation.error());
    source.finish();
    if (auto made = make_output_folder(arguments.out); !made) return made;
    EarlierResults earlier(arguments.out);
    if (auto written = write_result_files(arguments.out, *evaluation->made, evaluation->analyses,
                                          {evaluation->failed, {}});
        !written)
        return written;
    earlier.are_replaced();
    std::printf("results are in %s\n", arguments.out.c_str());
    return check_complete(*evaluation);
}

/// Rank 0 says what is wrong with the project before the others begin.
Result<void> lead_all(const Arguments& arguments, int ranks, const std::stop_token& stop, bool& others_wait) {
    auto run = open_shared_run(arguments.request);
    auto journal = run ? open_journal(arguments, *run) : Result<Journal>(fail(run.error()));
    int begins = journal.has_value();
    others_wait = begins;
    MPI_Bcast(&begins, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (!journal) return fail(journal.error());
    if (ranks > 1) run->request.threads = 1;  // it waits for units in the thread that talks to the others
    return lead(arguments, *run, *journal, ranks, stop);
}

Result<void> follow(const Arguments& arguments, int rank, const std::stop_token& stop) {
    int begins = 0;
    MPI_Bcast(&begins, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (!begins) return {};
    const auto run = open_shared_run(arguments.request);
    if (!run) return fail(run.error());
    BegunUnits begun(arguments.journal, rank);
    return compute_what_is_handed_out(*run, begun, stop);
}

void add_options(CLI::App& command, Arguments& arguments) {
    add_run_options(command, arguments.request);
    command.add_option("--out", arguments.out, "folder for the results")
        ->type_name("DIR")
        ->capture_default_str();
    command
        .add_option("--journal", arguments.journal,
                    "folder for the parts, which all ranks see; covaria merge reads it too")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_flag("--resume", arguments.resume, "go on with the parts that are in the journal");
}

/// `others_wait`: set where they have to be ended after an error.
int run_ranks(const Arguments& arguments, const std::stop_token& stop, bool& others_wait) {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const auto done = guarded([&] {
        return rank == 0 ? lead_all(arguments, ranks, stop, others_wait) : follow(arguments, rank, stop);
    });
    const auto outcome = done ? *done : Result<void>(fail(done.error()));
    if (outcome) return exit_success;
    print_error(outcome.error());
    return exit_status_of(outcome.error());
}

}  // namespace

int main(int argc, char** argv) {
    show_control_characters();
    CLI::App app(
        "Shares a run of Covaria between the ranks that mpirun starts: rank 0 hands out units and merges\n"
        "them in order, the others compute. The results have the bits of covaria run.",
        "covaria-mpi");
    app.set_version_flag("--version", std::string("covaria-mpi ") + version());
    app.footer("Example:\n  mpirun -n 33 covaria-mpi run my.covaria --journal parts --out out");
    app.require_subcommand(1);
    Arguments arguments;
    add_options(*app.add_subcommand("run", "Evaluate a project; write results.json and CSV tables"),
                arguments);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        if (problem.get_exit_code() == 0) return app.exit(problem);
        const std::string wrong = what_does_not_exist(app, argc, argv);
        if (wrong.empty())
            app.exit(problem);
        else
            std::fprintf(stderr, "%s\n", wrong.c_str());
        return exit_wrong_usage;
    }
    if (arguments.request.threads == 0) arguments.request.threads = 1;  // a rank is a core
    const Interrupt interrupt;
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    bool others_wait = true;
    const int status = run_ranks(arguments, interrupt.token(), others_wait);
    if (status != exit_success && others_wait) MPI_Abort(MPI_COMM_WORLD, status);
    MPI_Finalize();
    return all_is_printed() || status != exit_success ? status : exit_bad_input;
}
