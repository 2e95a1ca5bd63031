// What the runner calls in its worker threads: the core, or something scripted in tests.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/project/workspace.h"

namespace covaria::ui {

using ProjectSnapshot = std::shared_ptr<const Project>;
using PreparedPointer = std::shared_ptr<const PreparedAnalysis>;
using ResultPointer = std::shared_ptr<const UncertaintyResult>;

/// An analysis ready to run, or why it is not.
struct Preparation {
    PreparedPointer analysis;  ///< null: `message` says why
    std::string message = {};
    std::vector<std::string> warnings = {};  ///< of its assets and of its model
};

struct RunBackend {
    /// All analyses of the project, by id.
    std::function<std::map<std::string, Preparation>(const Project&)> prepare;
    std::function<Result<UncertaintyResult>(const PreparedAnalysis&)> first_order;
    std::function<Result<UncertaintyResult>(const PreparedAnalysis&, const RunControl&)> full;
};

/// core/project and core/propagation.
RunBackend core_backend();

}  // namespace covaria::ui
