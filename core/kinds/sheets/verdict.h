// The statistical tests of a sheet: figure, limits, verdict, as a row of a table.
#pragma once

#include <optional>
#include <string>

#include "core/text/table.h"

namespace covaria::sheets {

/// A figure is held against one limit or two, all in the figure's unit.
struct StatisticalTest {
    Message question;
    double figure = 0.0;  ///< SI, as the limits
    std::optional<double> low = {}, high = {};
    Unit unit = {};
    bool passed() const { return (!low || figure >= *low) && (!high || figure <= *high); }
};

/// Whether something conforms, by the probability that it does and the one that is asked for; between both
/// nothing is decided (ISO 14253-1, JCGM 106).
struct Decision {
    Decision(double probability, double wanted)
        : conforms(probability >= wanted), fails(probability <= 1.0 - wanted) {}
    TestVerdict verdict() const;
    bool conforms, fails;
};

/// An empty table of tests.
Table table_of_tests(std::string id, std::string title);
void add_test(Table& table, const StatisticalTest& test);

}  // namespace covaria::sheets
