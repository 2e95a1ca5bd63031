// The statistical tests of a sheet: figure, limits, verdict, as a row of a table.
#pragma once

#include <optional>
#include <string>

#include "core/base/data_table.h"

namespace covaria::sheets {

/// A figure is held against one limit or two, all in the figure's unit.
struct StatisticalTest {
    Message question;
    double figure = 0.0;  ///< SI, as the limits
    std::optional<double> low = {}, high = {};
    Unit unit = {};
    bool passed() const { return (!low || figure >= *low) && (!high || figure <= *high); }
};

/// An empty table of tests.
DataTable table_of_tests(std::string id, std::string title);
void add_test(DataTable& table, const StatisticalTest& test);

}  // namespace covaria::sheets
