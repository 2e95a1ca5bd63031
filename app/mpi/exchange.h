// Messages between ranks: rank 0 hands out ranges of units, the others send partial results back.
#pragma once

#include "app/merged_run.h"
#include "app/mpi/begun_units.h"

namespace covaria {

/// Rank 0 of several: hands out units in their order, keeps what comes back in the journal.
class HandingOut : public UnitSource {
public:
    /// `careful`: units that have ended a rank before; each is handed out alone.
    HandingOut(const SharedRun& run, PartsFolder& journal, int ranks, std::vector<DeadlyUnit> careful,
               std::stop_token stop);
    bool wait_for(std::size_t work, std::uint64_t unit) override;
    /// Waits until all other ranks know that there is no more to do.
    void finish();
    const std::optional<Error>& problem() const { return problem_; }

private:
    bool answer_one();
    void answer(int rank, std::uint64_t work);
    UnitRange next_range(std::size_t work);
    bool is_careful(std::size_t work, std::uint64_t unit) const;
    bool served(std::size_t work) const;

    const SharedRun& run_;
    PartsFolder& journal_;
    std::vector<DeadlyUnit> careful_;
    std::stop_token stop_;
    std::vector<std::uint64_t> next_;  ///< first unit of each work not handed out yet
    std::vector<std::uint64_t> at_;    ///< the work that each other rank has asked for last
    std::size_t current_ = 0;          ///< earlier works have their results
    std::optional<Error> problem_;
};

/// Any other rank: computes what it is handed until there is no more. Errors: stopped, a unit without values.
Result<void> compute_what_is_handed_out(const SharedRun& run, BegunUnits& begun, const std::stop_token& stop);

}  // namespace covaria
