// Common ground of the searches of a design: candidates evaluated on several threads, counted, in order.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/design/candidate.h"
#include "core/propagation/run_monitor.h"

namespace covaria::detail {

/// Thrown where a stop was requested; ends in run_design.
struct Stopped {};

/// The judges of all threads; one that nobody uses is lent.
class JudgePool {
public:
    JudgePool(const PreparedDesign& design, References references)
        : design_(design), references_(std::move(references)) {}
    /// Given back when the pointer dies.
    std::shared_ptr<CandidateJudge> lend();

private:
    const PreparedDesign& design_;
    References references_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<CandidateJudge>> idle_;
};

/// Notes on what was evaluated on one thread: merged into the book in order.
struct SearchNotes {
    /// `whole`: of as many rows as may be kept; others are no steps.
    void add(const Candidate& candidate, const Judged& judged, const Message& search, bool whole);

    std::uint64_t evaluations = 0;
    std::map<std::string, DesignReason> reasons;  ///< reasons by what they say in English
    std::vector<DesignStep> steps;                ///< each better than the one before
};

/// The book of one run of a design: all that it keeps beside the candidates themselves.
class SearchBook {
public:
    SearchBook(const PreparedDesign& design, References references, const RunControl& control);

    /// Judges the candidates, in their order. Throws Stopped.
    std::vector<Judged> judge_all(const std::vector<Candidate>& candidates, const Message& search);
    void merge(const SearchNotes& notes);
    /// Evaluations that are left of those allowed.
    std::uint64_t left() const;
    /// After an evaluation, on any thread: progress. False: stop.
    bool advance(const Judged& judged, bool whole);
    /// Whether it has as many rows as are to be kept.
    bool is_whole(const Candidate& candidate) const;

    const PreparedDesign& design() const { return design_; }
    JudgePool& judges() { return judges_; }
    RunMonitor& monitor() { return monitor_; }
    const SearchNotes& notes() const { return notes_; }

private:
    const PreparedDesign& design_;
    JudgePool judges_;
    std::atomic<double> best_;
    RunControl control_;
    RunMonitor monitor_;
    SearchNotes notes_;
};

}  // namespace covaria::detail
