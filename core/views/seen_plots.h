// Residuals of redundant readings as charts.
#pragma once

#include <vector>

#include "core/evidence/redundant_readings.h"
#include "core/text/document_language.h"
#include "core/text/plot_specification.h"

namespace covaria {

/// Names of what residuals can be drawn over: their order, then the abscissas of the readings.
std::vector<Message> residual_abscissas(const evidence::RedundantReadings& readings);
/// The chart of w of the readings over one of these; those of one figure stand out. A reading that has no
/// abscissa is left out.
PlotSpecification residual_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                std::size_t abscissa = 0,
                                const DocumentLanguage& in = DocumentLanguage::english());
/// The chart of w of the readings of one figure in rising order over the quantiles of the normal
/// distribution: they are on the line where the stated figure holds.
PlotSpecification quantile_plot(const evidence::RedundantReadings& readings, std::size_t figure,
                                const DocumentLanguage& in = DocumentLanguage::english());

/// The histogram of w of the readings of one figure, with the normal distribution that holds where the figure
/// does. Nothing where it has no w.
PlotSpecification residual_histogram(const evidence::RedundantReadings& readings, std::size_t figure,
                                     const DocumentLanguage& in = DocumentLanguage::english());

}  // namespace covaria
