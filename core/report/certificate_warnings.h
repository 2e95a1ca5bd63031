// Warnings about the results of a certificate before it goes out.
#pragma once

#include "core/report/report.h"

namespace covaria {

/// Under an accreditation, a warning for each analysis with a fixed k whose y ± U has, for its degrees of
/// freedom or by its trials, another probability than about 95 % although k alone promises it: k = 2 of three
/// degrees of freedom is 86 %.
Problems improbable_results(const ReportSource& source);
/// A warning for each result of which the evaluated U may not be stated.
Problems results_beyond_capability(const ReportSource& source);

}  // namespace covaria
