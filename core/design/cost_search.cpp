#include "core/design/cost_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace covaria::detail {

namespace {

constexpr double cheaper = 1.0 - 1e-12;           ///< factor that counts as an improvement
constexpr std::size_t most_one_for_two = 10'000;  ///< choices that one row in place of two may be

}  // namespace

CostSearch::CostSearch(SearchBook& book, std::vector<double> values)
    : book_(book), values_(std::move(values)), choice_(book.design()) {}

void CostSearch::judge(const std::vector<Rows>& choices, const Message& search) {
    std::vector<Candidate> candidates;
    for (const Rows& rows : choices)
        if (!known_.contains(rows)) candidates.push_back({values_, rows});
    const std::vector<Judged> judged = book_.judge_all(candidates, search);
    const References references = book_.judges().lend()->references();
    for (std::size_t i = 0; i < judged.size(); ++i) {
        const double ratio = judged[i].expanded.empty()
                                 ? std::numeric_limits<double>::infinity()
                                 : objective_of(DesignObjective::largest, judged[i].expanded, references);
        known_.try_emplace(candidates[i].rows, Known{judged[i].merit(), ratio});
    }
}

const Rows& CostSearch::best_of(const std::vector<Rows>& choices, const Message& search) {
    judge(choices, search);
    return *std::min_element(choices.begin(), choices.end(), [&](const Rows& a, const Rows& b) {
        return known_.at(a).merit < known_.at(b).merit;
    });
}

bool CostSearch::take_if_better(const std::vector<Rows>& choices, const Message& search, Rows& rows) {
    if (choices.empty() || book_.left() == 0) return false;
    const Rows& best = best_of(choices, search);
    if (!(known_.at(best).merit < cheaper * known_.at(rows).merit)) return false;
    rows = best;
    return true;
}

std::vector<Rows> CostSearch::with_one_less(const Rows& rows) const {
    std::vector<Rows> choices;
    if (rows.size() <= choice_.least) return choices;
    for (const std::size_t row : rows)
        if (!choice_.is_fixed(row)) choices.push_back(removed(rows, row));
    return choices;
}

std::vector<Rows> CostSearch::with_one_more(const Rows& rows) const {
    std::vector<Rows> choices;
    for (std::size_t row = 0; rows.size() < choice_.keep && row < choice_.count; ++row)
        if (!contains(rows, row)) choices.push_back(added(rows, row));
    return choices;
}

std::vector<Rows> CostSearch::with_another(const Rows& rows) const {
    std::vector<Rows> choices;
    for (const std::size_t gone : rows)
        for (std::size_t row = 0; !choice_.is_fixed(gone) && row < choice_.count; ++row)
            if (!contains(rows, row)) choices.push_back(added(removed(rows, gone), row));
    return choices;
}

std::vector<Rows> CostSearch::with_one_for_two(const Rows& rows) const {
    std::vector<Rows> choices;
    if (rows.size() <= choice_.least || rows.size() * rows.size() / 2 * choice_.count > most_one_for_two)
        return choices;
    for (const std::size_t first : rows)
        for (const std::size_t second : rows) {
            if (second <= first || choice_.is_fixed(first) || choice_.is_fixed(second)) continue;
            const Rows others = removed(removed(rows, first), second);
            for (std::size_t row = 0; row < choice_.count; ++row)
                if (!contains(rows, row)) choices.push_back(added(others, row));
        }
    return choices;
}

double CostSearch::number_of_all() const {
    double number = 0.0;
    for (std::size_t size = fewest(); size <= choice_.keep; ++size) number += choice_.number(size);
    return number;
}

void CostSearch::try_all() {
    for (std::size_t size = fewest(); size <= choice_.keep; ++size)
        choice_.for_all(size,
                        [this](const std::vector<Rows>& choices) { judge(choices, tell<"all choices">()); });
}

/// Adds the row that brings the largest ratio down most for its price, one after the other; backwards from
/// all rows where a few do not suffice.
Rows CostSearch::greedy() {
    Rows rows = choice_.fixed;
    double ratio = std::numeric_limits<double>::infinity();
    const DesignChoice& prices = *book_.design().design.choose;
    while (rows.size() < choice_.keep && ratio > 1.0) {
        const std::vector<Rows> choices = with_one_more(rows);
        judge(choices, tell<"greedy">());
        const auto worth = [&](const Rows& more) {
            const double now = known_.at(more).ratio;
            if (!std::isfinite(ratio)) return -now * prices.price_of(more);  // the first with a result
            const double gained = ratio - std::max(1.0, now);
            return gained / std::max(1e-300, prices.price_of(more) - prices.price_of(rows));
        };
        const auto best = std::max_element(choices.begin(), choices.end(),
                                           [&](const Rows& a, const Rows& b) { return worth(a) < worth(b); });
        rows = *best;
        ratio = known_.at(rows).ratio;
    }
    if (!rows.empty() && (std::isfinite(ratio) || rows.size() < choice_.keep)) {
        judge({rows}, tell<"greedy">());
        return rows;
    }
    rows = choice_.all();
    while (rows.size() > choice_.keep) rows = best_of(with_one_less(rows), tell<"backward elimination">());
    judge({rows}, tell<"backward elimination">());
    return rows;
}

Rows CostSearch::improved(Rows rows, const Message& search) {
    judge({rows}, search);
    while (take_if_better(with_one_less(rows), search, rows) ||
           take_if_better(with_another(rows), search, rows) ||
           take_if_better(with_one_more(rows), search, rows) ||
           take_if_better(with_one_for_two(rows), search, rows)) {
    }
    return rows;
}

std::vector<DesignCost> CostSearch::front() const {
    std::vector<DesignCost> all;
    for (const auto& [rows, known] : known_)
        if (std::isfinite(known.ratio) && rows.size() <= choice_.keep)
            all.push_back({known.ratio, book_.design().design.choose->price_of(rows)});
    std::sort(all.begin(), all.end(), [](const DesignCost& a, const DesignCost& b) {
        return a.largest_ratio != b.largest_ratio ? a.largest_ratio < b.largest_ratio : a.cost < b.cost;
    });
    std::vector<DesignCost> best;
    for (const DesignCost& one : all)
        if (best.empty() || one.cost < best.back().cost) best.push_back(one);
    return best;
}

CostSearch::Found CostSearch::find() {
    Found found;
    const double choices = number_of_all();
    if (choices <= most_choices && choices <= static_cast<double>(book_.left())) {
        try_all();
        found.proved = true;
    } else {
        improved(greedy(), tell<"exchange">());
        for (std::size_t start = 1; start < book_.design().design.starts && book_.left() > 0; ++start)
            improved(choice_.at_random(start), tell<"start %1">(start + 1));
    }
    const auto best = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
        const bool small_a = a.first.size() <= choice_.keep, small_b = b.first.size() <= choice_.keep;
        return small_a != small_b ? small_a : a.second.merit < b.second.merit;
    });
    found.rows = best->first;
    found.has_result = std::isfinite(best->second.ratio);
    found.front = front();
    return found;
}

}  // namespace covaria::detail
