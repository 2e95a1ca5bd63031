// The values of one quantity of a Digital Calibration Certificate, in D-SI (all versions).
#pragma once

#include <string>
#include <vector>

#include "core/readers/reader.h"
#include "core/readers/stated_quantities.h"
#include "core/readers/xml_text.h"

namespace covaria {

/// The values of one <quantity>: a single one, or those of a list; their symbols are empty.
struct DccQuantity {
    int line = 0;
    std::string name, ref_type;
    bool scalar = false;
    std::vector<StatedQuantity> values;
    std::vector<StatedCorrelation> correlations = {};
};

/// Reads a quantity, hybrid values in their first unit that is known. Parts that are not read go to
/// `left_out`, with their lines: texts, complex values, unknown units, coverage intervals (their standard
/// uncertainty is taken). Error with line and column: a value or an uncertainty that is no number, lists of
/// different lengths.
Result<DccQuantity> read_dcc_quantity(const XmlText& xml, const pugi::xml_node& quantity,
                                      Proposals& proposals);

/// The English name of an element if it has one, else its name in the first language.
std::string dcc_name(const pugi::xml_node& node);

}  // namespace covaria
