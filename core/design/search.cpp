#include "core/design/search.h"

#include <algorithm>

#include "core/propagation/parallel_blocks.h"

namespace covaria::detail {

std::shared_ptr<CandidateJudge> JudgePool::lend() {
    std::unique_ptr<CandidateJudge> judge;
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            judge = std::move(idle_.back());
            idle_.pop_back();
        }
    }
    if (!judge) judge = std::make_unique<CandidateJudge>(design_, references_);
    return {judge.release(), [this](CandidateJudge* lent) {
                const std::lock_guard lock(mutex_);
                idle_.emplace_back(lent);
            }};
}

void SearchNotes::add(const Candidate& candidate, const Judged& judged, const Message& search, bool whole) {
    ++evaluations;
    if (!judged.feasible() && judged.expanded.empty())
        ++reasons.try_emplace(judged.reason.english(), DesignReason{judged.reason, 0}).first->second.count;
    if (judged.feasible() && whole && (steps.empty() || judged.objective < steps.back().objective))
        steps.push_back({evaluations, search, judged.objective, candidate.values});
}

SearchBook::SearchBook(const PreparedDesign& design, References references, const RunControl& control)
    : design_(design),
      judges_(design, std::move(references)),
      best_(std::numeric_limits<double>::infinity()),
      control_{control.stop, {}, control.threads},
      monitor_(control_, design.design.most_evaluations) {
    if (!control.progress) return;
    control_.progress = [this, progress = control.progress](const Progress& done) {
        const double best = best_;
        Progress with_best = done;
        if (std::isfinite(best)) with_best.best = best;
        progress(with_best);
    };
}

bool SearchBook::advance(const Judged& judged, bool whole) {
    double best = best_;
    while (whole && judged.feasible() && judged.objective < best &&
           !best_.compare_exchange_weak(best, judged.objective)) {
    }
    return monitor_.advance(1);
}

bool SearchBook::is_whole(const Candidate& candidate) const {
    return !design_.table || design_.design.objective == DesignObjective::cost ||
           candidate.rows.size() == design_.design.choose->keep;
}

std::vector<Judged> SearchBook::judge_all(const std::vector<Candidate>& candidates, const Message& search) {
    std::vector<Judged> all;
    OrderedWork<Judged> work;
    work.units = candidates.size();
    work.make_partial = [] { return Judged{}; };
    work.make_worker = [&] {
        return [this, &candidates, judge = judges_.lend()](std::uint64_t unit, Judged& judged) {
            judged = judge->judge(candidates[unit]);
            return advance(judged, is_whole(candidates[unit]));
        };
    };
    work.merge = [&](std::uint64_t unit, Judged& judged) {
        notes_.add(candidates[unit], judged, search, is_whole(candidates[unit]));
        all.push_back(std::move(judged));
        return true;
    };
    if (run_in_order(work, monitor_) == WorkEnd::cancelled) throw Stopped{};
    return all;
}

void SearchBook::merge(const SearchNotes& notes) {
    for (const DesignStep& step : notes.steps)
        if (notes_.steps.empty() || step.objective < notes_.steps.back().objective)
            notes_.steps.push_back(
                {notes_.evaluations + step.evaluation, step.search, step.objective, step.values});
    notes_.evaluations += notes.evaluations;
    for (const auto& [words, reason] : notes.reasons)
        notes_.reasons.try_emplace(words, DesignReason{reason.reason, 0}).first->second.count += reason.count;
}

std::uint64_t SearchBook::left() const {
    const std::uint64_t most = design_.design.most_evaluations;
    return most > notes_.evaluations ? most - notes_.evaluations : 0;
}

}  // namespace covaria::detail
