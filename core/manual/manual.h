// The manual: all pages of help, the guides, the examples with their pictures, and the command line, in one
// document.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/document/report_document.h"

namespace covaria {

/// A command as it describes itself.
struct CommandWords {
    std::string name, description;
    std::vector<std::pair<std::string, std::string>> options;
    std::string examples = {};  ///< examples as --help shows them
};

/// Error{not_found}: a page or a picture is missing.
Result<ReportDocument> build_manual(const std::vector<CommandWords>& commands);

}  // namespace covaria
