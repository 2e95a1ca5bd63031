// The charts of what the search for a design found, as plot specifications.
#pragma once

#include <vector>

#include "core/result/design_result.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria {

/// Those there is something for: ratios before and after, objective against number of rows, what each row is
/// worth, cost against uncertainty, the way of the search.
std::vector<PlotSpecification> design_plots(const DesignResult& result,
                                            const DocumentLanguage& language = {});

}  // namespace covaria
