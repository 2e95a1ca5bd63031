// The result of a search for a design, as tables and as JSON.
#pragma once

#include <string>
#include <vector>

#include "core/result/design_result.h"
#include "core/text/table.h"

namespace covaria {

/// The tables of a design, with full precision: "outputs", and as far as there are any "values", "rows",
/// "gains", "sources", "curve", "front", "path", "reasons".
std::vector<Table> design_tables(const DesignResult& result);
/// The tables that people read of a design: rounded, without the way of the search and without columns that
/// say nothing.
std::vector<Table> readable_design_tables(const DesignResult& result);
/// The text that people read on a terminal.
std::string design_text(const DesignResult& result);

}  // namespace covaria
