#include "core/design/row_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random/uniforms.h"

namespace covaria::detail {

namespace {

constexpr double most_choices = 50'000;    ///< that are all evaluated
constexpr std::size_t batch = 512;         ///< of all choices, at once
constexpr double better = 1.0 - 1e-12;     ///< what counts as an improvement
constexpr std::size_t further_counts = 3;  ///< of rows beyond those kept, on the curve

Rows added(Rows rows, std::size_t row) {
    rows.insert(std::lower_bound(rows.begin(), rows.end(), row), row);
    return rows;
}

Rows removed(Rows rows, std::size_t row) {
    rows.erase(std::lower_bound(rows.begin(), rows.end(), row));
    return rows;
}

bool contains(const Rows& rows, std::size_t row) {
    return std::binary_search(rows.begin(), rows.end(), row);
}

}  // namespace

double number_of_choices(std::size_t n, std::size_t k) {
    double number = 1.0;
    for (std::size_t i = 1; i <= std::min(k, n - k); ++i)
        number = number * static_cast<double>(n - i + 1) / static_cast<double>(i);
    return std::min(std::round(number), std::numeric_limits<double>::max());
}

RowSearch::RowSearch(SearchBook& book, std::vector<double> values)
    : book_(book),
      values_(std::move(values)),
      count_(book.design().table->rows.rows.size()),
      keep_(book.design().design.choose->keep),
      least_(std::max<std::size_t>(1, book.design().table->least)),
      fixed_(book.design().design.choose->fixed) {
    std::sort(fixed_.begin(), fixed_.end());
}

bool RowSearch::is_fixed(std::size_t row) const {
    return contains(fixed_, row);
}

void RowSearch::judge(const std::vector<Rows>& choices, const std::string& search) {
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

const Rows& RowSearch::best_of(const std::vector<Rows>& choices, const std::string& search) {
    judge(choices, search);
    return *std::min_element(choices.begin(), choices.end(), [&](const Rows& a, const Rows& b) {
        return merit_of(a).merit < merit_of(b).merit;
    });
}

std::vector<Rows> RowSearch::with_one_more(const Rows& rows) const {
    std::vector<Rows> choices;
    for (std::size_t row = 0; row < count_; ++row)
        if (!contains(rows, row)) choices.push_back(added(rows, row));
    return choices;
}

std::vector<Rows> RowSearch::with_one_less(const Rows& rows) const {
    std::vector<Rows> choices;
    for (const std::size_t row : rows)
        if (!is_fixed(row)) choices.push_back(removed(rows, row));
    return choices;
}

std::vector<Rows> RowSearch::with_another(const Rows& rows, std::size_t in_place_of) const {
    std::vector<Rows> choices;
    const Rows others = removed(rows, in_place_of);
    for (std::size_t row = 0; row < count_; ++row)
        if (!contains(rows, row)) choices.push_back(added(others, row));
    return choices;
}

RowSearch::Found RowSearch::find() {
    Found found;
    const double choices = number_of_choices(count_ - fixed_.size(), keep_ - fixed_.size());
    if (choices <= most_choices && choices <= static_cast<double>(book_.left())) {
        found.rows = of_all_choices();
        found.proved = true;
    } else {
        found.rows = exchanged(greedy(), "exchange");
        for (std::size_t start = 1; start < book_.design().design.starts && book_.left() > 0; ++start) {
            const Rows other = exchanged(at_random(start), "start " + std::to_string(start + 1));
            if (merit_of(other).merit < merit_of(found.rows).merit) found.rows = other;
        }
    }
    found.feasible = merit_of(found.rows).feasible;
    return found;
}

RowSearch::Found RowSearch::improve(const Rows& rows) {
    Found found{exchanged(rows, "exchange")};
    found.feasible = merit_of(found.rows).feasible;
    return found;
}

// Choices in lexicographic order, as masks of the rows that are not fixed.
Rows RowSearch::of_all_choices() {
    Rows free_rows;
    for (std::size_t row = 0; row < count_; ++row)
        if (!is_fixed(row)) free_rows.push_back(row);
    std::vector<bool> taken(free_rows.size(), false);
    std::fill_n(taken.begin(), keep_ - fixed_.size(), true);
    Rows best;
    std::vector<Rows> choices;
    const auto judge_batch = [&] {
        if (choices.empty()) return;
        const Rows& one = best_of(choices, "all choices");
        if (best.empty() || merit_of(one).merit < merit_of(best).merit) best = one;
        choices.clear();
    };
    do {
        Rows rows = fixed_;
        for (std::size_t i = 0; i < taken.size(); ++i)
            if (taken[i]) rows.push_back(free_rows[i]);
        std::sort(rows.begin(), rows.end());
        choices.push_back(std::move(rows));
        if (choices.size() == batch) judge_batch();
    } while (std::prev_permutation(taken.begin(), taken.end()));
    judge_batch();
    return best;
}

Rows RowSearch::greedy() {
    Rows rows = fixed_;
    while (rows.size() < keep_) {
        rows = best_of(with_one_more(rows), "greedy");
        if (!merit_of(rows).feasible) return backward();
    }
    judge({rows}, "greedy");
    return rows;
}

// Where a few rows do not suffice for a model: from all of them down.
Rows RowSearch::backward() {
    Rows rows;
    for (std::size_t row = 0; row < count_; ++row) rows.push_back(row);
    judge({rows}, "backward elimination");
    while (rows.size() > keep_) rows = best_of(with_one_less(rows), "backward elimination");
    return rows;
}

Rows RowSearch::exchanged(Rows rows, const std::string& search) {
    judge({rows}, search);
    for (bool improved = true; improved;) {
        improved = false;
        const Rows before = rows;
        for (const std::size_t row : before) {
            if (book_.left() == 0) return rows;
            if (is_fixed(row) || !contains(rows, row) || rows.size() == count_) continue;
            const Rows other = best_of(with_another(rows, row), search);
            if (!(merit_of(other).merit < better * merit_of(rows).merit)) continue;
            rows = other;
            improved = true;
        }
    }
    return rows;
}

Rows RowSearch::at_random(std::size_t start) const {
    Rows rows = fixed_, free_rows;
    for (std::size_t row = 0; row < count_; ++row)
        if (!is_fixed(row)) free_rows.push_back(row);
    std::vector<double> u(free_rows.size());
    uniforms(book_.design().design.seed, DrawPurpose::design_starts, static_cast<std::uint32_t>(start), 0, u);
    for (std::size_t i = 0; rows.size() < keep_; ++i) {  // Fisher and Yates
        const auto last = static_cast<double>(free_rows.size() - i);
        std::swap(free_rows[i], free_rows[i + static_cast<std::size_t>(u[i] * last)]);
        rows.push_back(free_rows[i]);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

std::vector<DesignCount> RowSearch::curve(const Rows& rows) {
    const std::size_t fewest = std::max(least_, fixed_.size());
    for (Rows fewer = rows; fewer.size() > fewest && merit_of(fewer).feasible;) {
        const auto choices = with_one_less(fewer);
        if (choices.empty()) break;
        fewer = best_of(choices, "fewer rows");
    }
    Rows more = rows;
    while (more.size() < std::min(count_, rows.size() + further_counts))
        more = best_of(with_one_more(more), "more rows");
    Rows all;
    for (std::size_t row = 0; row < count_; ++row) all.push_back(row);
    judge({all}, "more rows");
    std::vector<DesignCount> counts;
    for (const auto& [count, objective] : best_by_count_) counts.push_back({count, objective});
    return counts;
}

std::vector<std::optional<double>> RowSearch::without_each(const Rows& rows) {
    std::vector<std::optional<double>> objectives;
    for (const std::size_t row : rows) {
        if (rows.size() <= least_) {
            objectives.emplace_back();
            continue;
        }
        const Rows others = removed(rows, row);
        judge({others}, "without a row");
        const Merit merit = merit_of(others);
        objectives.push_back(merit.feasible ? std::optional<double>(merit.merit) : std::nullopt);
    }
    return objectives;
}

}  // namespace covaria::detail
