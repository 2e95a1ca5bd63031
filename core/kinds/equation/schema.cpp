// The fields of "measurement equation".
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/equation/setup.h"
#include "core/kinds/instruments/sensor.h"
#include "core/quantity/statement.h"

namespace covaria::equation_model {

namespace {

FieldSpec equations_field() {
    return {
        .key = "equations",
        .title = "Equations",
        .kind = FieldKind::text,
        .help =
            "One equation a line: y = x_1*x_2 + 3 [mm]. Names without an equation are input quantities. "
            "'solve y = 1: y^2 = x' finds y in every trial, from its starting value. '#' starts a comment.",
        .default_value = std::string("y = x_1 + x_2"),
        .section = "Equations",
        .several_lines = true};
}

FieldSpec outputs_table() {
    FieldSpec table{
        .key = "outputs",
        .title = "Results",
        .kind = FieldKind::table,
        .help =
            "What is reported, and in which unit. Without rows: every name that an equation defines "
            "and no other one uses, in SI units.",
        .optional = true,
        .section = "Equations"};
    table.columns = {{.key = "symbol",
                      .title = "symbol",
                      .kind = FieldKind::text,
                      .help = "Name that an equation defines."},
                     {.key = "name",
                      .title = "name",
                      .kind = FieldKind::text,
                      .optional = true,
                      .help = "What it is, for tables and reports."},
                     {.key = "unit",
                      .title = "unit",
                      .kind = FieldKind::text,
                      .optional = true,
                      .help = "Unit of the result; empty: the SI unit that follows from the equations."},
                     {.key = "role",
                      .title = "role",
                      .kind = FieldKind::choice,
                      .optional = true,
                      .choices = {{"measurand", "measurand"}, {"intermediate", "intermediate"}},
                      .help = "Measurands have coverage regions together; empty: measurand."},
                     {.key = "group",
                      .title = "group",
                      .kind = FieldKind::text,
                      .optional = true,
                      .help = "Results of one group have a joint coverage region."}};
    return table;
}

ColumnSpec statement_column() {
    ColumnSpec column{
        .key = "statement",
        .title = "stated as",
        .kind = FieldKind::choice,
        .optional = true,
        .choices = {{"constant", "constant"}},
        .help =
            "How its uncertainty is known; a and b are then: u; U and k; U and p in %; half-width "
            "(and inexactness, or ratio of top to base); lower and upper limit; step of the "
            "indication; permissible error and % of the value; number of counts; number of "
            "observations in the mean (pooled). Empty: a constant."};
    for (const StatementKind& kind : statement_kinds())
        column.choices.push_back({std::string(kind.key), std::string(kind.title)});
    column.choices.push_back({"observations", "observations (Type A)"});
    column.choices.push_back({"pooled", "pooled observations (Type A)"});
    column.choices.push_back({"instrument", "reading of an instrument"});
    return column;
}

std::vector<ColumnSpec> figure_columns() {
    return {{.key = "a",
             .title = "a",
             .optional = true,
             .help = "First figure of the statement, in the row's unit."},
            {.key = "b", .title = "b", .optional = true, .help = "Second figure of the statement."},
            {.key = "nu",
             .title = "nu",
             .range = {.low = 0.0, .low_open = true},
             .optional = true,
             .help = "Degrees of freedom; empty: infinite, or those of the observations."},
            {.key = "r_u",
             .title = "r_u",
             .unit = Unit::of("%"),
             .range = {.low = 0.0},
             .optional = true,
             .help = "Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3)."},
            {.key = "source",
             .title = "source",
             .kind = FieldKind::text,
             .optional = true,
             .help = "Where the figure comes from: certificate, data sheet, handbook."},
            {.key = "instrument",
             .title = "instrument",
             .kind = FieldKind::reference,
             .optional = true,
             .help = "Instrument of the project that reads the quantity, a distance.",
             .capabilities = {SensorSource::capability, BallbarSource::capability}}};
}

FieldSpec quantities_table() {
    FieldSpec table{
        .key = "quantities",
        .title = "Quantities",
        .kind = FieldKind::table,
        .help =
            "One row for each component of uncertainty. The first row of a symbol has its value and "
            "unit; further rows of the same symbol add components and have no value.",
        .optional = true,
        .section = "Quantities",
        .states_quantities = true};
    table.columns = {
        {.key = "symbol",
         .title = "symbol",
         .kind = FieldKind::text,
         .help = "Name that the equations use: x_1, alpha_s."},
        {.key = "name",
         .title = "name",
         .kind = FieldKind::text,
         .optional = true,
         .help = "What it is, or what the component is."},
        {.key = "value",
         .title = "value",
         .optional = true,
         .help = "Estimate, in the row's unit; empty where observations or limits give it."},
        {.key = "unit",
         .title = "unit",
         .kind = FieldKind::text,
         .optional = true,
         .help = "Unit of value, a and b; empty: 1. A difference of temperatures is given in K."},
        statement_column()};
    for (ColumnSpec& column : figure_columns()) table.columns.push_back(std::move(column));
    return table;
}

FieldSpec observations_table() {
    FieldSpec table{
        .key = "observations",
        .title = "Observations",
        .kind = FieldKind::table,
        .help =
            "Repeated observations for Type A evaluations, typed, pasted or from a CSV file. "
            "Observations of several quantities with the same numbers were made together: their means "
            "are then correlated (JCGM 100 5.2.3).",
        .optional = true,
        .section = "Quantities"};
    table.columns = {
        {.key = "quantity", .title = "quantity", .kind = FieldKind::text, .help = "Symbol of the quantity."},
        {.key = "number",
         .title = "number",
         .kind = FieldKind::integer,
         .optional = true,
         .help = "Number of the simultaneous observation; empty: the quantity was observed by itself."},
        {.key = "series",
         .title = "series",
         .kind = FieldKind::text,
         .optional = true,
         .help = "Name of an earlier series of the same procedure, for a pooled standard deviation."},
        {.key = "value", .title = "value", .help = "Observed value, in the unit of the quantity."}};
    return table;
}

}  // namespace

SetupSchema equation_schema() {
    FieldSpec type_a{
        .key = "type_a",
        .title = "Means of observations",
        .kind = FieldKind::choice,
        .help =
            "Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of "
            "the observations (JCGM 101 6.4.9), or normal.",
        .default_value = std::string("student-t"),
        .choices = {{"student-t", "Student t"}, {"normal", "normal"}},
        .section = "Quantities"};
    return SetupSchema(
        {equations_field(), outputs_table(), quantities_table(), observations_table(), type_a});
}

}  // namespace covaria::equation_model
