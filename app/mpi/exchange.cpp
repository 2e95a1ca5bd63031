#include "app/mpi/exchange.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

#include "core/base/bytes.h"

namespace covaria {

namespace {

constexpr int request_tag = 1, range_tag = 2;

/// Waiting in MPI would keep a core busy.
void wait_a_little() {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
}

/// "Here are these units, and what is next of work w?" Work after the last one: nothing more is wanted.
struct Request {
    std::uint64_t work = 0;
    UnitRange range = {};
    std::vector<std::string> partials = {};

    std::string bytes() const {
        ByteWriter writer;
        for (const std::uint64_t number : {work, range.first, range.last}) writer.put(number);
        for (const std::string& partial : partials) writer.put_list(partial);
        return writer.take();
    }
    static Request of(const std::string& bytes) {
        ByteReader reader(bytes);
        Request request;
        for (std::uint64_t* number : {&request.work, &request.range.first, &request.range.last})
            *number = reader.get<std::uint64_t>();
        for (std::uint64_t u = request.range.first; u < request.range.last && !reader.is_short(); ++u)
            reader.get_list(request.partials.emplace_back());
        return request;
    }
};

/// Units of one work, as rank 0 hands them out.
class HandedUnits : public UnitStore {
public:
    HandedUnits(const UnitWork& work, std::uint64_t index, BegunUnits& begun, std::stop_token stop)
        : work_(work), index_(index), begun_(begun), stop_(std::move(stop)) {}

    bool only_computes() const override { return true; }
    std::optional<UnitRange> next_range() override {
        const std::string bytes = std::exchange(done_, {index_}).bytes();
        asked_last_ = 0;
        if (bytes.size() > std::size_t{std::numeric_limits<int>::max()}) {
            too_large_ = true;
            return {};
        }
        MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, request_tag, MPI_COMM_WORLD);
        int there = 0;
        while (!there) {
            MPI_Iprobe(0, range_tag, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
            if (stop_.stop_requested()) return {};
            if (!there) wait_a_little();
        }
        std::array<std::uint64_t, 2> range{};
        MPI_Recv(range.data(), 2, MPI_UINT64_T, 0, range_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (range[0] == range[1]) return {};
        done_.range = {range[0], range[0]};
        asked_last_ = range[1];
        return UnitRange{range[0], range[1]};
    }
    void begins(std::uint64_t unit) override { begun_.begins(work_, unit); }
    bool keep(std::uint64_t unit, std::string bytes) override {
        begun_.ends(work_, unit);
        done_.partials.push_back(std::move(bytes));
        done_.range.last = unit + 1;
        return true;
    }
    /// Whether units that were handed out are not computed.
    bool owes() const { return too_large_ || done_.range.last != asked_last_; }

private:
    const UnitWork& work_;
    std::uint64_t index_;
    BegunUnits& begun_;
    std::stop_token stop_;
    Request done_{index_};
    std::uint64_t asked_last_ = 0;
    bool too_large_ = false;
};

}  // namespace

Result<void> compute_what_is_handed_out(const SharedRun& run, BegunUnits& begun,
                                        const std::stop_token& stop) {
    for (std::size_t w = 0; w < run.works.size(); ++w) {
        HandedUnits units(run.works[w], w, begun, stop);
        const auto done = compute_units(run, run.works[w], units, stop);
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "the evaluation was stopped");
        if (units.owes())
            return fail(ErrorCode::numeric,
                        run.works[w].name() + ": units were not computed: " +
                            (done ? "they are too large to be sent" : done.error().message));
    }
    begun.clear();
    const UnitWork none;
    HandedUnits(none, run.works.size(), begun, stop).next_range();
    return {};
}

HandingOut::HandingOut(const SharedRun& run, PartsFolder& journal, int ranks, std::vector<DeadlyUnit> careful,
                       std::stop_token stop)
    : run_(run),
      journal_(journal),
      careful_(std::move(careful)),
      stop_(std::move(stop)),
      next_(run.works.size(), 0),
      at_(static_cast<std::size_t>(ranks - 1), 0) {}

bool HandingOut::is_careful(std::size_t work, std::uint64_t unit) const {
    return std::any_of(careful_.begin(), careful_.end(), [&](const DeadlyUnit& deadly) {
        return deadly.unit == unit && deadly.analysis == run_.works[work].analysis &&
               deadly.study == run_.works[work].study;
    });
}

UnitRange HandingOut::next_range(std::size_t w) {
    if (w < current_) return {};
    const UnitWork& work = run_.works[w];
    const std::uint64_t most =
        std::max<std::uint64_t>(units_per_part(work.units), static_cast<std::uint64_t>(run_.request.threads));
    std::uint64_t& next = next_[w];
    while (next < work.units && journal_.has(work, next)) ++next;
    UnitRange range{next, next};
    while (range.last < work.units && range.size() < most && !journal_.has(work, range.last)) {
        const bool alone = is_careful(w, range.last);
        if (alone && range.size() > 0) break;
        ++range.last;
        if (alone) break;
    }
    next = range.last;
    return range;
}

void HandingOut::answer(int rank, std::uint64_t work) {
    const UnitRange range =
        work < run_.works.size() ? next_range(static_cast<std::size_t>(work)) : UnitRange{};
    at_[static_cast<std::size_t>(rank - 1)] = range.size() == 0 ? work + 1 : work;
    const std::array<std::uint64_t, 2> numbers{range.first, range.last};
    MPI_Send(numbers.data(), 2, MPI_UINT64_T, rank, range_tag, MPI_COMM_WORLD);
}

bool HandingOut::answer_one() {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, request_tag, MPI_COMM_WORLD, &there, &status);
    if (!there) return false;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, request_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    Request request = Request::of(bytes);
    // The rank has its next range before this one is written.
    answer(status.MPI_SOURCE, request.work);
    if (request.range.size() == 0) return true;
    const UnitWork& work = run_.works[static_cast<std::size_t>(request.work)];
    const auto kept =
        journal_.add(run_.part_request(), PartSection{work, request.range, std::move(request.partials)});
    if (!kept && !problem_) problem_ = kept.error();
    return true;
}

/// Whether some rank computes units of this work, or will.
bool HandingOut::served(std::size_t work) const {
    return std::any_of(at_.begin(), at_.end(), [&](std::uint64_t at) { return at <= work; });
}

bool HandingOut::wait_for(std::size_t work, std::uint64_t unit) {
    current_ = std::max(current_, work);
    while (!journal_.has(run_.works[work], unit)) {
        if (stop_.stop_requested() || problem_) return false;
        if (answer_one()) continue;
        if (!served(work)) return journal_.has(run_.works[work], unit);
        wait_a_little();
    }
    return true;
}

void HandingOut::finish() {
    current_ = run_.works.size();
    const auto all_know = [&] {
        return std::all_of(at_.begin(), at_.end(), [&](std::uint64_t at) { return at > run_.works.size(); });
    };
    while (!all_know() && !stop_.stop_requested())
        if (!answer_one()) wait_a_little();
}

}  // namespace covaria
