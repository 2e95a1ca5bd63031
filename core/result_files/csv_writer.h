// Tables and charts as CSV (RFC 4180): full precision, units in the heads.
#pragma once

#include <string>

#include "core/text/display_units.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria {

std::string to_csv(const Table& table, const DisplayUnits& units = {});
/// The numbers of a chart, a table of each series below the one before.
std::string plot_csv(const PlotSpecification& plot);

}  // namespace covaria
