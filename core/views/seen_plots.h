// Residuals of redundant readings as charts.
#pragma once

#include "core/evidence/redundant_readings.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria {

/// The chart of w of the readings in their order; those of one figure stand out.
PlotSpecification residual_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                const DocumentLanguage& in = DocumentLanguage::english());
/// The chart of w of the readings of one figure in rising order over the quantiles of the normal
/// distribution: they are on the line where the stated figure holds.
PlotSpecification quantile_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                const DocumentLanguage& in = DocumentLanguage::english());

}  // namespace covaria
