#include "core/models/group_setup.h"

#include <cmath>
#include <map>

#include "core/math/special_quantiles.h"
#include "core/quantity/type_a.h"

namespace covaria::group_observations {

namespace {

class GroupReader {
public:
    GroupReader(const SetupReader& reader, Problems& problems) : reader_(reader), problems_(problems) {}

    std::optional<GroupSetup> run() {
        const auto unit = Unit::parse(reader_.text("unit"));
        if (!unit) problems_.error("/unit", unit.error().message);
        setup_.unit = unit.value_or(Unit{});
        setup_.symbol = reader_.text("symbol");
        setup_.name = reader_.text("name");
        setup_.between_counts = reader_.text("between") == "included";
        if (reader_.text("data") == "summary")
            read_summary();
        else
            read_observations();
        if (!problems_.has_errors() && setup_.groups.size() < 2)
            problems_.error(table(), "an analysis of variance needs at least two groups");
        if (problems_.has_errors()) return std::nullopt;
        return std::move(setup_);
    }

private:
    std::string table() const { return reader_.text("data") == "summary" ? "/groups" : "/observations"; }

    void read_summary() {
        setup_.per_group = static_cast<std::size_t>(reader_.integer("per_group"));
        for (std::size_t row = 0; row < reader_.rows("groups"); ++row)
            setup_.groups.push_back({reader_.cell_text("groups", row, "group"),
                                     setup_.unit.to_si(reader_.cell_number("groups", row, "mean")),
                                     setup_.unit.interval_to_si(reader_.cell_number("groups", row, "s"))});
    }

    void read_observations() {
        std::vector<std::string> order;
        std::map<std::string, std::vector<double>> values;
        for (std::size_t row = 0; row < reader_.rows("observations"); ++row) {
            const std::string group = reader_.cell_text("observations", row, "group");
            if (!values.contains(group)) order.push_back(group);
            values[group].push_back(setup_.unit.to_si(reader_.cell_number("observations", row, "value")));
        }
        for (const std::string& group : order) {
            const auto series = type_a_evaluation(values[group]);
            if (!series)
                return problems_.error("/observations", "group '" + group + "': " + series.error().message);
            if (setup_.per_group == 0) setup_.per_group = values[group].size();
            if (values[group].size() != setup_.per_group)
                return problems_.error("/observations",
                                       "group '" + group + "' has " + std::to_string(values[group].size()) +
                                           " observations, others have " + std::to_string(setup_.per_group) +
                                           ": every group needs the same number");
            setup_.groups.push_back({group, series->mean, series->standard_deviation});
        }
    }

    const SetupReader& reader_;
    Problems& problems_;
    GroupSetup setup_;
};

std::vector<FieldSpec> quantity_fields() {
    const auto text = [](const char* key, const char* title, const char* help, const char* default_value) {
        return FieldSpec{.key = key,
                         .title = title,
                         .kind = FieldKind::text,
                         .help = help,
                         .default_value = std::string(default_value),
                         .section = "Quantity"};
    };
    return {text("symbol", "Symbol", "Of the measured quantity.", "V"),
            text("name", "Name", "What is measured.", "measured quantity"),
            text("unit", "Unit", "In which the observations are given.", "1")};
}

FieldSpec data_field() {
    return {.key = "data",
            .title = "Data",
            .kind = FieldKind::choice,
            .help = "Every observation, or mean and standard deviation of each group.",
            .default_value = std::string("observations"),
            .choices = {{"observations", "observations"}, {"summary", "means and standard deviations"}},
            .section = "Observations"};
}

std::vector<FieldSpec> tables() {
    FieldSpec observations{
        .key = "observations",
        .title = "Observations",
        .kind = FieldKind::table,
        .help =
            "Observations with the day, instrument or operator they belong to, typed, pasted or "
            "from a CSV file.",
        .min_rows = 4,
        .shown_if = Condition{"data", {"observations"}},
        .section = "Observations"};
    observations.columns = {
        {.key = "group", .title = "group", .kind = FieldKind::text, .help = "Day, instrument or operator."},
        {.key = "value", .title = "value", .help = "Observed value, in the unit of the quantity."}};
    FieldSpec groups{.key = "groups",
                     .title = "Groups",
                     .kind = FieldKind::table,
                     .help = "Mean and experimental standard deviation of the observations of each group.",
                     .min_rows = 2,
                     .shown_if = Condition{"data", {"summary"}},
                     .section = "Observations"};
    groups.columns = {
        {.key = "group", .title = "group", .kind = FieldKind::text, .help = "Day, instrument or operator."},
        {.key = "mean",
         .title = "mean",
         .help = "Of the observations of the group, in the unit of the quantity."},
        {.key = "s",
         .title = "s",
         .range = {.low = 0.0},
         .help = "Experimental standard deviation of a single observation of the group."}};
    FieldSpec per_group{.key = "per_group",
                        .title = "Observations per group",
                        .kind = FieldKind::integer,
                        .help = "Number of observations in each group.",
                        .range = {.low = 2.0, .high = 1e6},
                        .default_value = Quantity{5.0, Unit{}},
                        .shown_if = Condition{"data", {"summary"}},
                        .section = "Observations"};
    return {observations, groups, per_group};
}

}  // namespace

SetupSchema group_schema() {
    std::vector<FieldSpec> fields = quantity_fields();
    fields.push_back(data_field());
    for (FieldSpec& field : tables()) fields.push_back(std::move(field));
    fields.push_back({.key = "between",
                      .title = "Effect of the groups",
                      .kind = FieldKind::choice,
                      .help =
                          "Included: u of the mean from the scatter of the groups' means. Not included: all "
                          "observations count as independent, which the F-test in the evaluation must allow.",
                      .default_value = std::string("included"),
                      .choices = {{"included", "included"}, {"none", "not included"}},
                      .section = "Evaluation"});
    return SetupSchema(std::move(fields));
}

std::optional<GroupSetup> read_group_setup(const SetupReader& reader, Problems& problems) {
    return GroupReader(reader, problems).run();
}

Variances variances_of(const GroupSetup& setup) {
    std::vector<double> means;
    double within = 0.0;
    for (const Group& group : setup.groups) {
        means.push_back(group.mean);
        within += group.standard_deviation * group.standard_deviation;
    }
    const double J = double(setup.groups.size()), K = double(setup.per_group);
    Variances v;
    const TypeA of_means = type_a_evaluation(means).value_or(TypeA{});
    v.mean = of_means.mean;
    v.s_of_means = of_means.standard_deviation;
    v.nu_a = J - 1.0;
    v.nu_b = J * (K - 1.0);
    v.s_a = std::sqrt(K) * v.s_of_means;
    v.s_b = std::sqrt(within / J);
    v.ratio = v.s_b > 0.0 ? v.s_a * v.s_a / (v.s_b * v.s_b) : 0.0;
    v.s_between = std::sqrt(std::max(0.0, (v.s_a * v.s_a - v.s_b * v.s_b) / K));
    if (setup.between_counts) {
        v.u = v.s_of_means / std::sqrt(J);
        v.degrees_of_freedom = v.nu_a;
    } else {
        v.degrees_of_freedom = J * K - 1.0;
        v.u = std::sqrt((v.nu_a * v.s_a * v.s_a + v.nu_b * v.s_b * v.s_b) / v.degrees_of_freedom / (J * K));
    }
    return v;
}

std::vector<DataTable> group_evaluation(const GroupSetup& setup, const Variances& v) {
    const Unit unit = setup.unit.interval();
    DataTable table{"anova", "Analysis of variance", {{"what"}, {"value", {}, false, 3}}, {}, {}};
    const auto deviation = [&](const char* what, double s) {
        table.rows.push_back({std::string(what), Quantity{unit.interval_from_si(s), unit}});
    };
    deviation("standard deviation of the means of the groups", v.s_of_means);
    deviation("s_a, from the means of the groups", v.s_a);
    deviation("s_b, within the groups", v.s_b);
    deviation("s_B, between the groups", v.s_between);
    table.rows.push_back({std::string("F = s_a²/s_b²"), v.ratio});
    const double limit = f_quantile(0.95, v.nu_a, v.nu_b);
    table.rows.push_back({std::string("95 % quantile of F"), limit});
    table.rows.push_back({std::string("97.5 % quantile of F"), f_quantile(0.975, v.nu_a, v.nu_b)});
    table.notes.push_back(v.ratio > limit ? "There is an effect of the groups at the level of 5 %."
                                          : "No effect of the groups is seen at the level of 5 %.");
    return {table};
}

}  // namespace covaria::group_observations
