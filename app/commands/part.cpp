// covaria part FILE --part 17/400: computes one part of a run that several machines share.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/run_options.h"
#include "app/examples_of_command.h"
#include "app/exit_status.h"
#include "app/output_folder.h"
#include "app/shared_run.h"
#include "app/terminal.h"

namespace covaria {
namespace {

struct PartArguments {
    RunRequest request;
    std::string part;
    std::uint64_t unit = 0;
    std::string out = "parts";
    bool resume = false;
};

struct PartNumber {
    std::uint64_t k = 0, n = 0;
};

Result<PartNumber> part_number(const std::string& text) {
    PartNumber number;
    const char* end = text.data() + text.size();
    const auto [after_k, bad_k] = std::from_chars(text.data(), end, number.k);
    const bool slash = bad_k == std::errc{} && after_k != end && *after_k == '/';
    if (slash) {
        const auto [after_n, bad_n] = std::from_chars(after_k + 1, end, number.n);
        if (bad_n == std::errc{} && after_n == end && number.k >= 1 && number.k <= number.n &&
            number.n <= 1'000'000)
            return number;
    }
    return fail(ErrorCode::usage,
                "--part: \"" + text + "\" is no part: give its number and that of all, 17/400");
}

/// Keeps one range of units in memory.
class OneRange : public UnitStore {
public:
    OneRange(PartSection& section) : section_(section) {}
    bool only_computes() const override { return true; }
    std::optional<UnitRange> next_range() override {
        if (given_ || section_.range.size() == 0) return {};
        given_ = true;
        return section_.range;
    }
    bool keep(std::uint64_t, std::string bytes) override {
        section_.partials.push_back(std::move(bytes));
        return true;
    }
    /// Whether the section has all of its range, or from the first unit on as many as the computation needs.
    bool has_enough() {
        const std::uint64_t computed = section_.partials.size();
        if (computed < section_.range.size() && (section_.range.first > 0 || computed == 0)) return false;
        section_.range.last = section_.range.first + computed;
        return true;
    }

private:
    PartSection& section_;
    bool given_ = false;
};

/// Units `range_of(work)` of each computation.
template <class RangeOf>
Result<Part> computed_part(const SharedRun& run, const std::stop_token& stop, RangeOf range_of) {
    Part part{run.part_request(), {}};
    for (const UnitWork& work : run.works) {
        PartSection section{work, range_of(work), {}};
        if (section.range.size() == 0) continue;
        OneRange store(section);
        const auto done = compute_units(run, work, store, stop);
        if (!done && done.error().code == ErrorCode::cancelled) return fail(done.error());
        // A computation without results is told here, and again where the parts are merged.
        if (!done)
            print_message(work.name() + ": " + done.error().message.english());
        else if (store.has_enough())
            part.sections.push_back(std::move(section));
    }
    return part;
}

std::string padded(std::uint64_t number, std::uint64_t greatest) {
    std::string text = std::to_string(number);
    text.insert(0, std::to_string(greatest).size() - text.size(), '0');
    return text;
}

/// Whether the file holds what this part would be.
bool is_there(const std::filesystem::path& file, const SharedRun& run) {
    const auto found = read_part(file);
    if (!found) return false;
    for (const PartSection& section : found->sections) {
        const auto same = [&](const UnitWork& work) {
            return work.name() == section.work.name() && work.fingerprint == section.work.fingerprint;
        };
        if (std::none_of(run.works.begin(), run.works.end(), same)) return false;
    }
    return true;
}

/// Computes one unit of all works and keeps nothing: for a unit that ends the process.
Result<void> replay_unit(const PartArguments& arguments, const SharedRun& run, const std::stop_token& stop) {
    const std::uint64_t unit = arguments.unit - 1;
    const auto part = computed_part(run, stop, [unit](const UnitWork& work) {
        return unit < work.units ? UnitRange{unit, unit + 1} : UnitRange{};
    });
    if (!part) return fail(part.error());
    for (const PartSection& section : part->sections)
        std::printf("unit %llu of %s was computed: %zu bytes\n",
                    static_cast<unsigned long long>(arguments.unit), section.work.name().c_str(),
                    section.partials.front().size());
    return {};
}

Result<void> compute_part(const PartArguments& arguments, const std::stop_token& stop) {
    if (arguments.part.empty() == (arguments.unit == 0))
        return fail(ErrorCode::usage,
                    "say which part to compute (--part 17/400), or which unit (--unit 137)");
    const auto number = arguments.unit > 0 ? PartNumber{1, 1} : part_number(arguments.part);
    if (!number) return fail(number.error());
    const auto run = open_shared_run(arguments.request);
    if (!run) return fail(run.error());
    if (arguments.unit > 0) return replay_unit(arguments, *run, stop);
    if (auto made = make_output_folder(arguments.out); !made) return made;
    const auto [k, n] = *number;
    const std::filesystem::path file = std::filesystem::path(arguments.out) /
                                       ("part-" + padded(k, n) + "-of-" + std::to_string(n) + part_extension);
    if (arguments.resume && is_there(file, *run)) {
        std::printf("%s is there\n", file.c_str());
        return {};
    }
    const auto part = computed_part(
        *run, stop, [k = k, n = n](const UnitWork& work) { return range_of_part(work.shared, k, n); });
    if (!part) return fail(part.error());
    if (auto written = write_part(file, *part); !written) return written;
    std::printf("%s\n", file.c_str());
    return {};
}

}  // namespace

Command part_command(CLI::App& app) {
    auto arguments = std::make_shared<PartArguments>();
    CLI::App* command = app.add_subcommand(
        "part", "Compute one part of a run that several machines share; covaria merge puts them together");
    add_examples(*command,
                 {{"part projects/gum/h1-end-gauge.covaria --part 1/2", "the first half, on one machine"},
                  {"part projects/gum/h1-end-gauge.covaria --part 2/2",
                   "the other one; covaria merge puts them together"}});
    add_run_options(*command, arguments->request);
    command->add_option("--part", arguments->part, "which of how many parts: 17/400")->type_name("K/N");
    command
        ->add_option("--unit", arguments->unit,
                     "compute this unit alone and keep nothing: to find out why it ends the program")
        ->type_name("U");
    command->add_option("--out", arguments->out, "folder for the parts")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_flag("--resume", arguments->resume, "do nothing where the part is there already");
    return {command, [arguments](const std::stop_token& stop) {
                const auto done = compute_part(*arguments, stop);
                if (done) return int(exit_success);
                print_error(done.error());
                return exit_status_of(done.error());
            }};
}

}  // namespace covaria
