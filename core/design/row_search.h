// The search for rows: all choices where they are few, else greedy with exchange (Fedorov 1972), iterated
// from the best with some rows changed at random (Lourenço, Martin, Stützle 2003: iterated local search).
#pragma once

#include <map>
#include <vector>

#include "core/design/rows.h"
#include "core/design/search.h"

namespace covaria::detail {

class RowSearch {
public:
    /// Begins a search at these values of the variables.
    RowSearch(SearchBook& book, std::vector<double> values);

    struct Found {
        Rows rows;
        bool feasible = false;
        bool proved = false;
    };
    Found find();
    /// Improves these rows by exchange; they stay where nothing gains.
    Found improve(const Rows& rows);
    /// The best of each number of rows at these values; `find` looks at some, this at those that differ from
    /// `rows` by a few.
    std::vector<DesignCount> curve(const Rows& rows);

private:
    struct Merit {
        double merit = 0.0;
        bool feasible = false;
    };
    /// Judges the choices that are not known yet, all at once.
    void judge(const std::vector<Rows>& choices, const Message& search);
    /// The choice with the smallest merit, the first of equal ones; the choices are judged first.
    const Rows& best_of(const std::vector<Rows>& choices, const Message& search);
    Merit merit_of(const Rows& rows) const { return known_.at(rows); }
    std::vector<Rows> with_one_more(const Rows& rows) const;
    std::vector<Rows> with_one_less(const Rows& rows) const;
    /// Choices with one of the partners in the place of a row.
    std::vector<Rows> with_another(const Rows& rows, std::size_t in_place_of, const Rows& partners) const;
    Rows promising(const Rows& rows, const Message& search);

    Rows of_all_choices();
    Rows greedy();
    Rows backward();
    enum class Partners { promising, all };
    Rows exchanged(Rows rows, const Message& search, Partners which);

    SearchBook& book_;
    std::vector<double> values_;
    RowChoice choice_;
    std::map<Rows, Merit> known_;
    std::map<std::size_t, double> best_by_count_;
};

}  // namespace covaria::detail
