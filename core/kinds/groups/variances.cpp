// Analysis of variance of observations in groups of any size.
#include <algorithm>
#include <cmath>

#include "core/kinds/groups/setup.h"
#include "core/kinds/groups/variance_table.h"
#include "core/math/special_quantiles.h"
#include "core/quantity/type_a.h"

namespace covaria::group_observations {

namespace {

class Analysis {
public:
    explicit Analysis(const GroupSetup& setup)
        : groups_(setup.groups), groups_count_(double(groups_.size())) {}

    Variances run(Between between) {
        sums_of_squares();
        if (between == Between::included)
            from_means();
        else if (between == Between::none)
            from_observations();
        else
            from_components();
        return v_;
    }

private:
    /// sum weight_j mean_j/sum weight_j, relative to the first mean: metres that differ by micrometres.
    template <class Weight>
    double mean_by(Weight weight) const {
        double sum = 0.0, weights = 0.0;
        for (const Group& group : groups_) {
            sum += weight(group) * (group.mean - groups_.front().mean);
            weights += weight(group);
        }
        return groups_.front().mean + sum / weights;
    }

    void sums_of_squares() {
        std::vector<double> means;
        double squared_counts = 0.0;
        for (const Group& group : groups_) {
            means.push_back(group.mean);
            v_.observations += group.count;
            squared_counts += group.count * group.count;
            v_.within_squares += group.sum_of_squares;
        }
        v_.s_of_means = type_a_evaluation(means).value_or(TypeA{}).standard_deviation;
        grand_mean_ = mean_by([](const Group& g) { return g.count; });
        for (const Group& group : groups_)
            v_.between_squares += group.count * (group.mean - grand_mean_) * (group.mean - grand_mean_);
        v_.nu_a = groups_count_ - 1.0;
        v_.nu_b = v_.observations - groups_count_;
        v_.group_size = (v_.observations - squared_counts / v_.observations) / v_.nu_a;
        v_.s_a = std::sqrt(v_.between_squares / v_.nu_a);
        v_.s_b = std::sqrt(v_.within_squares / v_.nu_b);
        v_.ratio = v_.s_a * v_.s_a / (v_.s_b * v_.s_b);
        v_.s_between = std::sqrt(std::max(0.0, (v_.s_a * v_.s_a - v_.s_b * v_.s_b) / v_.group_size));
    }

    /// The mean square of the means is unbiased for groups of any size, since all means have one weight.
    void from_means() {
        v_.mean = mean_by([](const Group&) { return 1.0; });
        v_.u = v_.s_of_means / std::sqrt(groups_count_);
        v_.degrees_of_freedom = v_.nu_a;
    }

    void from_observations() {
        v_.mean = grand_mean_;
        v_.degrees_of_freedom = v_.observations - 1.0;
        v_.u =
            std::sqrt((v_.between_squares + v_.within_squares) / (v_.degrees_of_freedom * v_.observations));
    }

    /// u^2 = 1/sum w_j with 1/w_j = s_B^2 + s_b^2/n_j; the degrees of freedom by Satterthwaite's formula from
    /// those of the two mean squares.
    void from_components() {
        if (!(v_.s_between > 0.0)) return from_observations();
        const double s2_between = v_.s_between * v_.s_between, s2_within = v_.s_b * v_.s_b;
        const auto weight = [&](const Group& g) { return 1.0 / (s2_between + s2_within / g.count); };
        double weights = 0.0, by_between = 0.0, by_within = 0.0;
        for (const Group& group : groups_) {
            const double w = weight(group);
            weights += w;
            by_between += w * w;
            by_within += w * w / group.count;
        }
        v_.mean = mean_by(weight);
        v_.u = std::sqrt(1.0 / weights);
        const double c_a = by_between / v_.group_size / (weights * weights);
        const double c_b = by_within / (weights * weights) - c_a;
        const double a = c_a * v_.s_a * v_.s_a, b = c_b * s2_within;
        v_.degrees_of_freedom = (a + b) * (a + b) / (a * a / v_.nu_a + b * b / v_.nu_b);
    }

    const std::vector<Group>& groups_;
    double groups_count_;
    double grand_mean_ = 0.0;
    Variances v_;
};

Unit deviation_unit(const Unit& unit) {
    return unit.interval();
}

Table groups_table(const GroupSetup& setup) {
    const Unit unit = deviation_unit(setup.unit);
    Table table{"groups", "Groups"};
    table.add("group");
    table.add("n");
    table.add("mean").in(setup.unit);
    table.add("s").in(unit).symbol().figure(3);
    for (const Group& group : setup.groups) {
        const double s = std::sqrt(group.sum_of_squares / (group.count - 1.0));
        table.row(
            {group.name, group.count, setup.reference + group.mean, group.count > 1.0 ? Cell(s) : Cell()});
    }
    return table;
}

}  // namespace

Variances variances_of(const GroupSetup& setup) {
    Variances v = Analysis(setup).run(setup.between);
    v.mean += setup.reference;
    return v;
}

std::vector<Table> group_evaluation(const GroupSetup& setup, const Variances& v) {
    const Unit unit = deviation_unit(setup.unit);
    Table table{"anova", "Components of variance"};
    table.add("quantity");
    table.add("value").figure(3);
    const auto deviation = [&](Message what, double s) {
        table.row({std::move(what), Quantity{unit.interval_from_si(s), unit}});
    };
    deviation(tell<"standard deviation of the means of the groups">(), v.s_of_means);
    deviation(tell<"s_a, from the means of the groups">(), v.s_a);
    deviation(tell<"s_b, within the groups">(), v.s_b);
    deviation(tell<"s_B, between the groups">(), v.s_between);
    table.row({tell<"n_0, size of the groups">(), v.group_size});
    const double limit = f_quantile(0.95, v.nu_a, v.nu_b);
    if (v.s_b > 0.0) table.row({tell<"F = s_a²/s_b²">(), v.ratio});
    table.row({tell<"95 % quantile of F">(), limit});
    table.row({tell<"97.5 % quantile of F">(), f_quantile(0.975, v.nu_a, v.nu_b)});
    table.notes.push_back(v.ratio > limit ? tell<"There is an effect of the groups at the level of 5 %.">()
                                          : tell<"No effect of the groups is seen at the level of 5 %.">());
    if (setup.between == Between::components && !(v.s_between > 0.0))
        table.notes.push_back(
            tell<"The component of variance between the groups is zero: all observations count as "
                 "independent.">());
    return {groups_table(setup),
            variance_table("variance", "Analysis of variance", unit,
                           {tell<"between the groups">(), v.between_squares, v.nu_a},
                           {tell<"within the groups">(), v.within_squares, v.nu_b}),
            table};
}

}  // namespace covaria::group_observations
