// The fields of "observations in groups", and the groups that follow from them.
#include "core/kinds/groups/setup.h"

#include <map>

#include "core/quantity/type_a.h"
#include "core/setup/fields.h"

namespace covaria::group_observations {

namespace {

using Data = StatedGroups::Data;
using Observation = StatedGroups::Observation;
using Summary = StatedGroups::Summary;

Columns<Observation> observation_columns() {
    return Columns<Observation>()
        .add(&Observation::group, "group", "group", "Day, instrument or operator.")
        .add(&Observation::value, "value", "value", "Observed value, in the unit of the quantity.",
             {.observed = true});
}

Columns<Summary> summary_columns() {
    return Columns<Summary>()
        .add(&Summary::group, "group", "group", "Day, instrument or operator.")
        .add(&Summary::mean, "mean", "mean", "Of the observations of the group, in the unit of the quantity.")
        .add(&Summary::s, "s", "s", "Experimental standard deviation of a single observation of the group.",
             {.range = {.low = 0.0}})
        .add(&Summary::n, "n", "n",
             "Number of observations in the group; empty: observations per group, as below.",
             {.range = {.low = 1.0, .high = 1e6}, .optional = true});
}

void add_quantity(Fields<StatedGroups>& fields) {
    fields.section("Quantity")
        .add(&StatedGroups::symbol, "symbol", "Symbol", "Of the measured quantity.",
             {.default_value = std::string("V")})
        .add(&StatedGroups::name, "name", "Name", "What is measured.",
             {.default_value = std::string("measured quantity")})
        .add(&StatedGroups::unit, "unit", "Unit", "In which the observations are given.",
             {.default_value = std::string("1")});
}

void add_observations(Fields<StatedGroups>& fields) {
    fields.section("Observations")
        .choice(&StatedGroups::data, "data", "Data",
                "Every observation, or mean and standard deviation of each group.",
                {{Data::observations, "observations", "observations"},
                 {Data::summary, "summary", "means and standard deviations"}},
                Data::observations)
        .table(&StatedGroups::observations, "observations", "Observations",
               "Observations with the day, instrument or operator they belong to, typed, pasted or "
               "from a CSV file.",
               observation_columns(), {.min_rows = 4, .measured = true})
        .table(&StatedGroups::summaries, "groups", "Groups",
               "Mean and experimental standard deviation of the observations of each group.",
               summary_columns(), {.min_rows = 2, .measured = true})
        .add(&StatedGroups::per_group, "per_group", "Observations per group",
             "Number of observations in each group whose row does not say it.",
             {.range = {.low = 2.0, .high = 1e6}, .default_value = Quantity{5.0, Unit{}}})
        .shown_where(&StatedGroups::data, {Data::observations}, &StatedGroups::observations)
        .shown_where(&StatedGroups::data, {Data::summary}, &StatedGroups::summaries,
                     &StatedGroups::per_group);
}

void add_stated(Fields<StatedGroups>& fields) {
    fields.section("Stated scatter")
        .add(
            &StatedGroups::stated_within, "stated_within", "Within the groups",
            "Standard deviation of one observation, in the unit of the quantity, as a data sheet or a budget "
            "states it: the view Seen holds it against the observations. Empty: nothing is stated.",
            {.range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&StatedGroups::stated_between, "stated_between", "Between the groups",
             "The same of the deviations that the observations of a group share. Empty: nothing is stated.",
             {.range = {.low = 0.0, .low_open = true}, .optional = true});
}

}  // namespace

const Fields<StatedGroups>& group_fields() {
    static const Fields<StatedGroups> fields = [] {
        Fields<StatedGroups> made;
        add_quantity(made);
        add_observations(made);
        made.section("Evaluation")
            .choice(&StatedGroups::between, "between", "Effect of the groups",
                    "Included: u of the mean of the groups' means from their scatter. By components of "
                    "variance: the same for groups of one size, else groups with more observations have "
                    "more weight. Not included: all observations count as independent, which the F-test "
                    "in the evaluation must allow.",
                    {{Between::included, "included", "included"},
                     {Between::components, "components", "by components of variance"},
                     {Between::none, "none", "not included"}},
                    Between::included);
        add_stated(made);
        return made;
    }();
    return fields;
}

namespace {

/// A value of the table, SI, less that of the first row.
double relative(GroupSetup& setup, double value, bool first) {
    const double si = setup.unit.to_si(value);
    if (first) setup.reference = si;
    return si - setup.reference;
}

void take_summaries(GroupSetup& setup) {
    for (const Summary& row : setup.summaries) {
        const double n = row.n.value_or(setup.per_group);
        const double s = setup.unit.interval_to_si(row.s);
        setup.groups.push_back(
            {row.group, n, relative(setup, row.mean, setup.groups.empty()), (n - 1.0) * s * s});
    }
}

void take_observations(GroupSetup& setup, Problems& problems) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> values;
    for (const Observation& row : setup.observations) {
        const double value = relative(setup, row.value, order.empty());
        if (!values.contains(row.group)) order.push_back(row.group);
        values[row.group].push_back(value);
    }
    for (const std::string& group : order) {
        const std::vector<double>& of_group = values[group];
        if (of_group.size() == 1) {
            setup.groups.push_back({group, 1.0, of_group.front(), 0.0});
            continue;
        }
        const auto series = type_a_evaluation(of_group);
        if (!series)
            return problems.error(group_fields().place(&StatedGroups::observations),
                                  tell<"group '%1': %2">(group, series.error().message));
        setup.groups.push_back(
            {group, double(of_group.size()), series->mean,
             series->degrees_of_freedom * series->standard_deviation * series->standard_deviation});
    }
}

void check(const GroupSetup& setup, Problems& problems) {
    const std::string table = setup.data == Data::summary ? group_fields().place(&StatedGroups::summaries)
                                                          : group_fields().place(&StatedGroups::observations);
    double observations = 0.0;
    for (const Group& group : setup.groups) observations += group.count;
    const auto groups = static_cast<double>(setup.groups.size());
    if (groups < 2.0)
        problems.error(table, tell<"an analysis of variance needs at least two groups">());
    else if (!(observations > groups))
        problems.error(table, tell<"no group has more than one observation: nothing tells the scatter within "
                                   "the groups from that between them">());
}

}  // namespace

SetupSchema group_schema() {
    return group_fields().schema();
}

std::optional<GroupSetup> read_group_setup(const SetupReader& reader, const AssetLibrary& assets,
                                           Problems& problems) {
    GroupSetup setup{group_fields().read(reader, assets, problems), {}, 0.0};
    if (setup.stated_between && !setup.stated_within)
        problems.error(group_fields().place(&StatedGroups::stated_within),
                       tell<"what is stated between the groups can only be held against the observations "
                            "together with what is stated within them">());
    for (std::optional<double>* stated : {&setup.stated_within, &setup.stated_between})
        if (*stated) *stated = setup.unit.interval_to_si(**stated);
    if (setup.data == Data::summary)
        take_summaries(setup);
    else
        take_observations(setup, problems);
    if (!problems.has_errors()) check(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

}  // namespace covaria::group_observations
