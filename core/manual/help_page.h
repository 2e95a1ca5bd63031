// The pages of help: those of resources/help, of every model and asset with its fields from the registries,
// of the options, and the glossary. Window and manual show the same blocks.
#pragma once

#include <string>
#include <vector>

#include "core/model/model_descriptor.h"
#include "core/report/report_document.h"

namespace covaria {

struct HelpPage {
    std::string id;  ///< "model-pose-from-points", "asset-artefact-2d", "glossary"; the anchor of its heading
    std::string title;
    std::vector<ReportBlock> blocks;
};

/// Error{not_found}: the file of the page is missing.
Result<HelpPage> help_page(const ModelDescriptor& model);
HelpPage help_page(const AssetDescriptor& asset);
/// The options of the evaluation.
HelpPage options_page();
/// The texts of a certificate.
HelpPage certificate_page();
/// A file of resources/help, its id without ".md".
Result<HelpPage> shipped_page(const std::string& id);

/// In the order of the manual.
Result<std::vector<HelpPage>> help_pages();

/// Where the help of a field, or of a column of a table, is on a page.
std::string field_anchor(const std::string& page, const std::string& field, const std::string& column = {});

}  // namespace covaria
