// The search for the cheapest rows with which all targets are met.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "core/design/rows.h"
#include "core/design/search.h"
#include "core/result/design_result.h"

namespace covaria::detail {

class CostSearch {
public:
    /// Begins a search at these values of the variables.
    CostSearch(SearchBook& book, std::vector<double> values);

    struct Found {
        Rows rows;
        bool has_result =
            false;  ///< else nothing that was tried has; targets that are not met are judged later
        bool proved = false;
        std::vector<DesignCost> front;  ///< costs of all that was evaluated: what is dearer reaches less
    };
    /// Searches all choices of at most `keep` rows where they are few, else greedily and by exchange, from
    /// the present design and from random choices.
    Found find();

private:
    struct Known {
        double merit = 0.0;
        double ratio = 0.0;  ///< largest U/target; infinite without a result
    };
    void judge(const std::vector<Rows>& choices, const Message& search);
    const Rows& best_of(const std::vector<Rows>& choices, const Message& search);
    bool take_if_better(const std::vector<Rows>& choices, const Message& search, Rows& rows);
    std::vector<Rows> with_one_less(const Rows& rows) const;
    std::vector<Rows> with_one_more(const Rows& rows) const;
    std::vector<Rows> with_another(const Rows& rows) const;
    std::vector<Rows> with_one_for_two(const Rows& rows) const;
    double number_of_all() const;
    std::size_t fewest() const { return std::max(choice_.least, choice_.fixed.size()); }
    void try_all();
    Rows greedy();
    Rows improved(Rows rows, const Message& search);
    std::vector<DesignCost> front() const;

    SearchBook& book_;
    std::vector<double> values_;
    RowChoice choice_;
    std::map<Rows, Known> known_;
};

}  // namespace covaria::detail
