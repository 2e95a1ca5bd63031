#include "core/design/row_search.h"

#include <algorithm>
#include <cmath>

namespace covaria::detail {

namespace {

constexpr double better = 1.0 - 1e-12;      ///< factor that counts as an improvement
constexpr std::size_t most_promising = 24;  ///< partners of an exchange, until the last
constexpr std::size_t most_idle = 3;        ///< starts without gain that end the search in a large table
constexpr std::size_t further_counts = 3;   ///< numbers of rows beyond those kept, on the curve

}  // namespace

RowSearch::RowSearch(SearchBook& book, std::vector<double> values)
    : book_(book), values_(std::move(values)), choice_(book.design()) {}

void RowSearch::judge(const std::vector<Rows>& choices, const Message& search) {
    std::vector<Candidate> candidates;
    for (const Rows& rows : choices)
        if (!known_.contains(rows)) candidates.push_back({values_, rows});
    const std::vector<Judged> judged = book_.judge_all(candidates, search);
    for (std::size_t i = 0; i < judged.size(); ++i) {
        known_.try_emplace(candidates[i].rows, Merit{judged[i].merit(), judged[i].feasible()});
        if (!judged[i].feasible()) continue;
        const auto [best, is_new] =
            best_by_count_.try_emplace(candidates[i].rows.size(), judged[i].objective);
        if (!is_new) best->second = std::min(best->second, judged[i].objective);
    }
}

const Rows& RowSearch::best_of(const std::vector<Rows>& choices, const Message& search) {
    judge(choices, search);
    return *std::min_element(choices.begin(), choices.end(), [&](const Rows& a, const Rows& b) {
        return merit_of(a).merit < merit_of(b).merit;
    });
}

std::vector<Rows> RowSearch::with_one_more(const Rows& rows) const {
    std::vector<Rows> choices;
    for (std::size_t row = 0; row < choice_.count; ++row)
        if (!contains(rows, row)) choices.push_back(added(rows, row));
    return choices;
}

std::vector<Rows> RowSearch::with_one_less(const Rows& rows) const {
    std::vector<Rows> choices;
    for (const std::size_t row : rows)
        if (!choice_.is_fixed(row)) choices.push_back(removed(rows, row));
    return choices;
}

std::vector<Rows> RowSearch::with_another(const Rows& rows, std::size_t in_place_of,
                                          const Rows& partners) const {
    std::vector<Rows> choices;
    const Rows others = removed(rows, in_place_of);
    for (const std::size_t row : partners)
        if (!contains(rows, row)) choices.push_back(added(others, row));
    return choices;
}

/// Rows by which most would be gained if there were room for one more; all where they are few.
Rows RowSearch::promising(const Rows& rows, const Message& search) {
    if (choice_.count <= rows.size() + most_promising) return choice_.all();
    std::vector<Rows> choices = with_one_more(rows);
    judge(choices, search);
    std::stable_sort(choices.begin(), choices.end(),
                     [&](const Rows& a, const Rows& b) { return merit_of(a).merit < merit_of(b).merit; });
    choices.resize(most_promising);
    Rows partners;
    for (const Rows& more : choices)
        std::set_difference(more.begin(), more.end(), rows.begin(), rows.end(), std::back_inserter(partners));
    std::sort(partners.begin(), partners.end());
    return partners;
}

RowSearch::Found RowSearch::find() {
    Found found;
    const double choices = choice_.number(choice_.keep);
    if (choices <= most_choices && choices <= static_cast<double>(book_.left())) {
        found.rows = of_all_choices();
        found.proved = true;
    } else {
        found.rows = exchanged(greedy(), tell<"exchange">(), Partners::promising);
        found.rows = exchanged(found.rows, tell<"exchange">(), Partners::all);
        std::size_t idle = 0;  // starts in a row that found nothing better
        const bool is_large = choice_.count > choice_.keep + most_promising;
        for (std::size_t start = 1; start < book_.design().design.starts && book_.left() > 0; ++start) {
            if (is_large && idle == most_idle) break;
            const Message search = tell<"start %1">(start + 1);
            const Rows other = exchanged(choice_.shaken(found.rows, start), search, Partners::promising);
            ++idle;
            if (!(merit_of(other).merit < better * merit_of(found.rows).merit)) continue;
            idle = 0;
            found.rows = exchanged(other, search, Partners::all);
        }
    }
    found.feasible = merit_of(found.rows).feasible;
    return found;
}

RowSearch::Found RowSearch::improve(const Rows& rows) {
    Found found{exchanged(rows, tell<"exchange">(), Partners::all)};
    found.feasible = merit_of(found.rows).feasible;
    return found;
}

Rows RowSearch::of_all_choices() {
    Rows best;
    choice_.for_all(choice_.keep, [&](const std::vector<Rows>& choices) {
        const Rows& one = best_of(choices, tell<"all choices">());
        if (best.empty() || merit_of(one).merit < merit_of(best).merit) best = one;
    });
    return best;
}

Rows RowSearch::greedy() {
    Rows rows = choice_.fixed;
    while (rows.size() < choice_.keep) {
        rows = best_of(with_one_more(rows), tell<"greedy">());
        if (!merit_of(rows).feasible) return backward();
    }
    judge({rows}, tell<"greedy">());
    return rows;
}

// Backward elimination from all rows, where a few do not suffice for a model.
Rows RowSearch::backward() {
    Rows rows = choice_.all();
    judge({rows}, tell<"backward elimination">());
    while (rows.size() > choice_.keep) rows = best_of(with_one_less(rows), tell<"backward elimination">());
    return rows;
}

Rows RowSearch::exchanged(Rows rows, const Message& search, Partners which) {
    judge({rows}, search);
    for (bool improved = true; improved;) {
        improved = false;
        const Rows before = rows;
        const Rows partners = which == Partners::all ? choice_.all() : promising(rows, search);
        for (const std::size_t row : before) {
            if (book_.left() == 0) return rows;
            if (choice_.is_fixed(row) || !contains(rows, row)) continue;
            const std::vector<Rows> choices = with_another(rows, row, partners);
            if (choices.empty()) continue;
            const Rows other = best_of(choices, search);
            if (!(merit_of(other).merit < better * merit_of(rows).merit)) continue;
            rows = other;
            improved = true;
        }
    }
    return rows;
}

std::vector<DesignCount> RowSearch::curve(const Rows& rows) {
    const std::size_t fewest = std::max(choice_.least, choice_.fixed.size());
    judge({rows}, "fewer rows");
    for (Rows fewer = rows; fewer.size() > fewest && merit_of(fewer).feasible;) {
        const auto choices = with_one_less(fewer);
        if (choices.empty()) break;
        fewer = best_of(choices, "fewer rows");
    }
    Rows more = rows;
    while (more.size() < std::min(choice_.count, rows.size() + further_counts))
        more = best_of(with_one_more(more), "more rows");
    judge({choice_.all()}, "more rows");
    std::vector<DesignCount> counts;
    for (const auto& [count, objective] : best_by_count_) counts.push_back({count, objective});
    return counts;
}

}  // namespace covaria::detail
