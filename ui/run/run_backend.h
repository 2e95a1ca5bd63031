// The computations that the runner calls in its worker threads: the core, or something scripted in tests.
#pragma once

#include <functional>
#include <memory>

#include "core/made/prepared_analysis.h"

namespace covaria::ui {

using PreparedPointer = std::shared_ptr<const PreparedAnalysis>;
using ResultPointer = std::shared_ptr<const UncertaintyResult>;

struct RunBackend {
    std::function<Result<UncertaintyResult>(const PreparedAnalysis&)> first_order;
    std::function<Result<UncertaintyResult>(const PreparedAnalysis&, const RunControl&)> full;
};

/// The backend of core/made and core/propagation.
RunBackend core_backend();

}  // namespace covaria::ui
