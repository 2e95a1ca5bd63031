// Pictures of analyses whose quantities are nowhere in space: the distribution of a result.
#pragma once

#include "app/pictures.h"

namespace covaria {

/// Of the first measurand of the wanted group; of its contributions where Monte Carlo did not run.
Result<void> write_chart(const EvaluatedAnalysis& evaluated, const PictureRequest& request,
                         const std::filesystem::path& file);
/// One for every output.
Result<void> write_charts(const EvaluatedAnalysis& evaluated, const std::filesystem::path& folder);

}  // namespace covaria
