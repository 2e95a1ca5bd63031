// The charts of the result of a search for a design, as plot specifications.
#pragma once

#include <vector>

#include "core/result/design_result.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria {

/// The charts that there is something for: ratios before and after, objective against number of rows, the
/// worth of each row, cost against uncertainty, the way of the search.
std::vector<PlotSpecification> design_plots(const DesignResult& result,
                                            const DocumentLanguage& language = {});

}  // namespace covaria
