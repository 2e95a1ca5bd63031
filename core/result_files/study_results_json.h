// Studies in results.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/result/study_result.h"

namespace covaria {

/// Axes, then for each output lists over the grid points (the last axis varies fastest), null where there is
/// no value; positions and covariances of points in space; reasons of points without values.
nlohmann::ordered_json study_json(const StudyResult& study);

}  // namespace covaria
