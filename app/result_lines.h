// The result lines of many runs as one table.
#pragma once

#include <string>

#include "app/evaluation.h"

namespace covaria {

/// A run among many: what it is called, and the folder with its results, beside the table.
struct NamedRun {
    std::string name, folder;
};

/// Head of the table: name, analysis, group, symbol, unit, estimate, u, U, k, p, low, high, met, folder,
/// problem.
std::string result_lines_head();
/// A line for every measurand of an evaluated project, in the units of its outputs; "met" is of the
/// requirement on it. One without figures, that says why, for every analysis without results.
std::string result_lines(const NamedRun& run, const Project& project, const Evaluation& evaluation);
/// The line of a run that could not begin.
std::string line_without_results(const NamedRun& run, const std::string& problem);

}  // namespace covaria
