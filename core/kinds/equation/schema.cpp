// The fields of "measurement equation".
#include "core/kinds/ballbar/ballbar.h"
#include "core/kinds/equation/setup.h"
#include "core/kinds/instruments/sensor.h"
#include "core/quantity/statement.h"

namespace covaria::equation_model {

namespace {

using Stated = StatedEquations;
const Further maybe{.optional = true};

Columns<StatedOutput> output_columns() {
    using Row = StatedOutput;
    return Columns<Row>()
        .add(&Row::symbol, "symbol", "symbol", "Name that an equation defines.")
        .add(&Row::name, "name", "name", "What it is, for tables and reports.", maybe)
        .add(&Row::unit, "unit", "unit",
             "Unit of the result; empty: the SI unit that follows from the equations.", maybe)
        .choice(&Row::role, "role", "role", "Measurands have coverage regions together; empty: measurand.",
                {{OutputRole::measurand, "measurand", "measurand"},
                 {OutputRole::intermediate, "intermediate", "intermediate"}},
                maybe)
        .add(&Row::group, "group", "group", "Results of one group have a joint coverage region.", maybe);
}

ColumnSpec statement_column() {
    ColumnSpec column{
        .key = "statement",
        .title = "stated as",
        .optional = true,
        .choices = {{"constant", "constant"}},
        .help =
            "How its uncertainty is known; a and b are then: u; s and n; U and k; U and p in %; half-width "
            "(and inexactness, or ratio of top to base); lower and upper limit; step of the "
            "indication; permissible error and % of the value; number of counts; number of "
            "observations in the mean (pooled); standard deviation (Laplace, Weibull about the value), scale "
            "(and shape); expected number of events; number of trials and probability in %. A sample is "
            "drawn as it is listed among the observations, a histogram has the edges of its cells there. "
            "Empty: a constant."};
    for (const StatementKind& kind : statement_kinds())
        column.choices.push_back({std::string(kind.key), std::string(kind.title)});
    column.choices.push_back({"observations", "observations (Type A)"});
    column.choices.push_back({"pooled", "pooled observations (Type A)"});
    column.choices.push_back({"sample", "sample of values"});
    column.choices.push_back({"histogram", "histogram"});
    column.choices.push_back({"instrument", "reading of an instrument"});
    return column;
}

void add_figures(Columns<StatedComponent>& columns) {
    using Row = StatedComponent;
    columns.add(&Row::a, "a", "a", "First figure of the statement.", maybe)
        .add(&Row::b, "b", "b", "Second figure of the statement.", maybe)
        .add(&Row::stated_unit, "stated_unit", "unit of a, b",
             "Unit of the statement's figures; empty: the row's. % and ppm of a quantity that has a unit are "
             "parts of its value.",
             maybe)
        .add(&Row::nu, "nu", "nu", "Degrees of freedom; empty: infinite, or those of the observations.",
             {.range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&Row::r_u, "r_u", "r_u",
             "Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).",
             {.unit = Unit::of("%"), .range = {.low = 0.0}, .optional = true})
        .add(&Row::source, "source", "source",
             "Where the figure comes from: certificate, data sheet, handbook.", maybe)
        .add(&Row::ensemble, "ensemble", "ensemble",
             "Name of the evaluation that gave several quantities together, with one and the same nu: their "
             "uncertainties rest on one estimate of variance, and they are drawn from a multivariate t "
             "distribution (JCGM 102 5.3.2). Correlation coefficients between them stand with the "
             "correlations of the analysis.",
             maybe)
        .add(&Row::instrument, {.key = "instrument",
                                .title = "instrument",
                                .optional = true,
                                .help = "Instrument of the project that reads the quantity, a distance.",
                                .capabilities = {SensorSource::capability, BallbarSource::capability}});
}

Columns<StatedComponent> component_columns() {
    using Row = StatedComponent;
    Columns<Row> columns;
    columns.add(&Row::symbol, "symbol", "symbol", "Name that the equations use: x_1, alpha_s.")
        .add(&Row::name, "name", "name", "What it is, or what the component is.", maybe)
        .add(&Row::value, "value", "value",
             "Estimate, in the row's unit; empty where observations or limits give it.", maybe)
        .add(&Row::unit, "unit", "unit",
             "Unit of the value, and of a and b where they have no other; empty: 1. A difference of "
             "temperatures is given in K.",
             maybe)
        .add(&Row::statement, statement_column());
    add_figures(columns);
    return columns;
}

Columns<Observation> observation_columns() {
    using Row = Observation;
    return Columns<Row>()
        .add(&Row::quantity, "quantity", "quantity", "Symbol of the quantity.")
        .add(&Row::number, "number", "number",
             "Number of the simultaneous observation; empty: the quantity was observed by itself.", maybe)
        .add(&Row::series, "series", "series",
             "Name of an earlier series of the same procedure, for a pooled standard deviation.", maybe)
        .add(&Row::value, "value", "value",
             "Observed value, value of a sample or edge of a histogram, in the unit of the quantity.",
             {.observed = true})
        .add(&Row::weight, "weight", "weight",
             "Of a value of a sample, or of the cell of a histogram that begins at this edge: counts, or "
             "parts of any sum. Empty: one in a sample, none behind the last edge.",
             {.range = {.low = 0.0}, .optional = true});
}

void add_equations(Fields<Stated>& fields) {
    fields.section("Equations")
        .add(&Stated::text, "equations", "Equations",
             "One equation a line: y = x_1*x_2 + x_3. Names without an equation are input quantities; a "
             "number "
             "has its unit in brackets: 3 [mm]. "
             "'solve y = 1: y^2 = x' finds y in every trial, from its starting value. complex(a, b) and "
             "polar(r, phi) make complex numbers, re, im, abs and arg real ones of them. '#' starts a "
             "comment.",
             {.default_value = std::string("y = x_1 + x_2"), .several_lines = true})
        .table(&Stated::outputs, "outputs", "Results",
               "What is reported, and in which unit. Without rows: every name that an equation defines "
               "and no other one uses, in the unit of the first quantity of the same dimension, else in SI "
               "units.",
               output_columns(), maybe);
}

void add_quantities(Fields<Stated>& fields) {
    fields.section("Quantities")
        .table(&Stated::components,
               {.key = "quantities",
                .title = "Quantities",
                .help = "One row for each component of uncertainty. The first row of a symbol has its value "
                        "and "
                        "unit; further rows of the same symbol add components and have no value.",
                .optional = true,
                .states_quantities = true},
               component_columns())
        .table(&Stated::observations,
               {.key = "observations",
                .title = "Observations",
                .help = "Repeated observations for Type A evaluations, typed, pasted or from a CSV file. "
                        "Observations of several quantities with the same numbers were made together: their "
                        "means are then correlated (JCGM 100 5.2.3).",
                .optional = true,
                .observes_quantities = true,
                .measured = true},
               observation_columns())
        .choice(&Stated::normal_means, "type_a", "Means of observations",
                "Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of "
                "the observations (JCGM 101 6.4.9), or normal.",
                {{false, "student-t", "Student t"}, {true, "normal", "normal"}}, false);
}

}  // namespace

const Fields<StatedEquations>& equation_fields() {
    static const auto fields = [] {
        Fields<Stated> made;
        add_equations(made);
        add_quantities(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::equation_model
