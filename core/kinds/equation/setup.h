// The set-up of "measurement equation" and what it becomes: program, input quantities, outputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/equation/program.h"
#include "core/model/offered.h"
#include "core/model/output_quantity.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::equation_model {

struct StatedOutput {
    std::string symbol, name, unit;
    OutputRole role = OutputRole::measurand;
    std::string group;
};

/// A row of the quantities: figures are as typed, the value in the row's unit, what is stated of it in a unit
/// of its own if it has one.
struct StatedComponent {
    std::string symbol, name;
    std::optional<double> value;
    std::string unit = "1";
    std::string statement;
    std::optional<double> a, b;
    std::string stated_unit;  ///< unit of a and b; empty: the row's
    std::optional<double> nu, r_u;
    std::string source;
    std::string ensemble;  ///< shared by quantities whose uncertainties one evaluation gave
    Referred instrument;
};

struct Observation {
    std::string quantity;
    std::optional<int> number;  ///< number of the simultaneous observation
    std::string series;
    double value = 0.0;            ///< as typed, in the unit of the quantity
    std::optional<double> weight;  ///< weight of the value in a sample, or of the cell that begins at an edge
};

/// The set-up as typed.
struct StatedEquations {
    std::string text;
    std::vector<StatedOutput> outputs;
    std::vector<StatedComponent> components;
    std::vector<Observation> observations;
    bool normal_means = false;  ///< means of observations are normal, instead of Student t
};
const Fields<StatedEquations>& equation_fields();

/// The observations of one quantity, in its unit.
struct ObservedQuantity {
    struct Series {
        std::string name;  ///< name of an earlier series; empty: the present one
        std::vector<double> values;
    };
    std::string symbol, name;
    Unit unit;
    std::vector<Series> series;
};

struct EquationSetup {
    equation::ParsedText parsed;
    equation::Program program;
    InputSet inputs;
    std::vector<OutputQuantity> outputs;
    std::vector<ObservedQuantity> observed;
};

/// Empty if `problems` got an error.
std::optional<EquationSetup> read_equation_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                 Problems& problems);

/// The Type A evaluation of each series; empty without observations.
std::vector<Table> observation_tables(const std::vector<ObservedQuantity>& observed);
/// A chart for each quantity: its observations in the order in which they stand, with their mean.
std::vector<PlotSpecification> observation_figures(const std::vector<ObservedQuantity>& observed);

/// Rows for the names in the equations that no table has yet: quantities without a value, measurands.
Setup with_rows_for_names(const Setup& setup);

/// Input quantities as the tables state them, with their units.
struct StatedQuantities {
    InputSet inputs;
    std::vector<equation::KnownSymbol> symbols;  ///< symbols of the same quantities
    std::vector<std::size_t> rows;               ///< row of the table where each is first named
    std::vector<ObservedQuantity> observed;      ///< those of the quantities that have observations
};
StatedQuantities read_quantities(const StatedEquations& stated, Problems& problems);

/// "/equations/1/14-16": line and columns, from 0 and 1.
std::string path_of(const equation::Place& place);
void report(const equation::TextProblems& found, Problems& problems);
/// Reports them; those about temperatures in degC with the ways out.
void report(const equation::TextProblems& found, const StatedEquations& stated, Problems& problems);

/// Ways out for a figure of a row that is stated as a part (in %, ppm) of a temperature in degC: the same
/// part of its reading, in K. `estimate`: SI.
std::vector<Remedy> remedies_for_part(const StatedEquations& stated, std::size_t row, const Unit& unit,
                                      double estimate);
/// Ways out for the statement in that row; `estimate`: SI, as far as it is known. For limits in degC of a
/// quantity in `unit`, which may be a difference: both are one, or both are temperatures.
std::vector<Remedy> remedies_for_statement(const StatedEquations& stated, std::size_t row, const Unit& unit,
                                           const std::optional<double>& estimate);

}  // namespace covaria::equation_model
