#include "core/kinds/groups/setup.h"

#include <cmath>
#include <map>

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
        const std::string between = reader_.text("between");
        setup_.between = between == "included"     ? Between::included
                         : between == "components" ? Between::components
                                                   : Between::none;
        if (reader_.text("data") == "summary")
            read_summary();
        else
            read_observations();
        if (!problems_.has_errors()) check();
        if (problems_.has_errors()) return std::nullopt;
        return std::move(setup_);
    }

private:
    std::string table() const { return reader_.text("data") == "summary" ? "/groups" : "/observations"; }

    void check() {
        double observations = 0.0;
        for (const Group& group : setup_.groups) observations += group.count;
        const auto groups = static_cast<double>(setup_.groups.size());
        if (groups < 2.0)
            problems_.error(table(), "an analysis of variance needs at least two groups");
        else if (!(observations > groups))
            problems_.error(table(),
                            "no group has more than one observation: nothing tells the scatter within "
                            "the groups from that between them");
    }

    /// A value of the table, SI, less that of the first row.
    double relative(double value, std::size_t row) {
        const double si = setup_.unit.to_si(value);
        if (row == 0) setup_.reference = si;
        return si - setup_.reference;
    }

    void read_summary() {
        const int per_group = reader_.integer("per_group");
        for (std::size_t row = 0; row < reader_.rows("groups"); ++row) {
            const double n = reader_.cell_empty("groups", row, "n") ? double(per_group)
                                                                    : reader_.cell_number("groups", row, "n");
            const double s = setup_.unit.interval_to_si(reader_.cell_number("groups", row, "s"));
            setup_.groups.push_back({reader_.cell_text("groups", row, "group"), n,
                                     relative(reader_.cell_number("groups", row, "mean"), row),
                                     (n - 1.0) * s * s});
        }
    }

    void read_observations() {
        std::vector<std::string> order;
        std::map<std::string, std::vector<double>> values;
        for (std::size_t row = 0; row < reader_.rows("observations"); ++row) {
            const std::string group = reader_.cell_text("observations", row, "group");
            if (!values.contains(group)) order.push_back(group);
            values[group].push_back(relative(reader_.cell_number("observations", row, "value"), row));
        }
        for (const std::string& group : order) {
            const std::vector<double>& of_group = values[group];
            if (of_group.size() == 1) {
                setup_.groups.push_back({group, 1.0, of_group.front(), 0.0});
                continue;
            }
            const auto series = type_a_evaluation(of_group);
            if (!series)
                return problems_.error("/observations", "group '" + group + "': " + series.error().message);
            setup_.groups.push_back(
                {group, double(of_group.size()), series->mean,
                 series->degrees_of_freedom * series->standard_deviation * series->standard_deviation});
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
         .help = "Experimental standard deviation of a single observation of the group."},
        {.key = "n",
         .title = "n",
         .kind = FieldKind::integer,
         .range = {.low = 1.0, .high = 1e6},
         .optional = true,
         .help = "Number of observations in the group; empty: observations per group, as below."}};
    FieldSpec per_group{.key = "per_group",
                        .title = "Observations per group",
                        .kind = FieldKind::integer,
                        .help = "Number of observations in each group whose row does not say it.",
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
    fields.push_back(
        {.key = "between",
         .title = "Effect of the groups",
         .kind = FieldKind::choice,
         .help = "Included: u of the mean of the groups' means from their scatter. By components of "
                 "variance: the same for groups of one size, else groups with more observations have "
                 "more weight. Not included: all observations count as independent, which the F-test "
                 "in the evaluation must allow.",
         .default_value = std::string("included"),
         .choices = {{"included", "included"},
                     {"components", "by components of variance"},
                     {"none", "not included"}},
         .section = "Evaluation"});
    return SetupSchema(std::move(fields));
}

std::optional<GroupSetup> read_group_setup(const SetupReader& reader, Problems& problems) {
    return GroupReader(reader, problems).run();
}

}  // namespace covaria::group_observations
