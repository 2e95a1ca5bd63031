// Pictures of analyses whose quantities are nowhere in space: the distribution of a result.
#pragma once

#include "app/pictures.h"

namespace covaria {

/// Draws the first measurand of the wanted group; its contributions where Monte Carlo did not run.
Result<void> write_chart(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                         const std::filesystem::path& file);
/// Draws one output, by its index. Needs an application (application.h).
Result<void> write_chart_of(const EvaluatedAnalysis& evaluated, std::size_t output,
                            const std::filesystem::path& file);

}  // namespace covaria
