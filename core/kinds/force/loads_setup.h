// The set-up of "force-moment loads", read: calibration matrix by least squares, cases to be decoupled.
//
// Loads l are by the rated loads and readings v by the rated outputs: v = A l + B l², with A near the
// identity. A row is a channel, a column the axis that is loaded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/force/axis_fields.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"

namespace covaria::force_loads {

/// Readings that are decoupled, with the loads that they mean.
struct Case {
    std::string name;
    std::string source;  ///< place in the set-up
    Eigen::VectorXd v;   ///< readings by rated outputs
    Eigen::VectorXd l;   ///< loads by rated loads
};

/// Least squares of one element: slope a (and b of the square) by rated values.
struct Element {
    double a = 0.0, b = 0.0;
    /// Square root of their covariance matrix: a = … + aa ε₁, b = … + ba ε₁ + bb ε₂.
    double aa = 0.0, ba = 0.0, bb = 0.0;
    double degrees_of_freedom = 0.0;
};

struct LoadsSetup {
    /// A row of a table of cases: readings or loads, SI.
    struct Given {
        std::string name;
        AxisFigures figures;
    };
    Offered<ForceSensorSource> sensor;
    bool by_loads = true;  ///< cases are given by their loads
    std::vector<Given> readings, loads;
    bool quadratic = false;
    bool pooled = false;
    bool student_t = false;
    bool full_hysteresis = false;  ///< whatever the load; else in proportion to it

    std::vector<Element> elements;  ///< row by row
    std::vector<std::size_t> rows;  ///< order in which rows are eliminated
    double condition = 0.0;         ///< condition number of A
    std::vector<Case> cases;
    std::size_t first_element = 0, first_reading = 0;  ///< input quantities

    const std::vector<ForceChannel>& channels() const { return sensor->channels(); }
    std::size_t size() const { return channels().size(); }
    const Element& element(std::size_t h, std::size_t c) const { return elements[h * size() + c]; }
    Element& element(std::size_t h, std::size_t c) { return elements[h * size() + c]; }
    Eigen::MatrixXd A() const;
    /// Reading of channel h per unit of load c, as an SI factor of a, and of b.
    double scale(std::size_t h, std::size_t c, int power = 1) const;
};

const Fields<LoadsSetup>& fields();
std::optional<LoadsSetup> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems);
/// Elements by least squares through zero; refuses a matrix that cannot be inverted.
void fit_matrix(LoadsSetup& setup, Problems& problems);
/// Loads of readings at the estimates; NaN where there are none.
Eigen::VectorXd decoupled(const LoadsSetup& setup, const Eigen::VectorXd& v);

/// Elements of the matrix, then the readings of every case.
InputSet inputs(LoadsSetup& setup);
std::vector<Table> tables(const LoadsSetup& setup);
std::vector<PlotSpecification> figures(const LoadsSetup& setup);

}  // namespace covaria::force_loads
