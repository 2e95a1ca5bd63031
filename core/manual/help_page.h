// The pages of help: those of resources/help, of every model and asset with its fields from the registries,
// of the options, and the glossary. Window and manual show the same blocks, each in its language.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"
#include "core/model/model_descriptor.h"
#include "core/text/document_language.h"

namespace covaria {

struct HelpPage {
    std::string id;  ///< "model-pose-from-points", "asset-artefact-2d", "glossary"; the anchor of its heading
    std::string title;
    std::vector<ReportBlock> blocks;
};

/// A file of resources/help, its id without ".md"; of the folder of the language, where it has the file.
/// Error {not_found}: there is none.
Result<HelpPage> shipped_page(const std::string& id, const DocumentLanguage& in = {});

/// All pages in the order of the manual. Error{not_found}: the file of a page is missing.
Result<std::vector<HelpPage>> help_pages(const DocumentLanguage& in = {});

/// Anchor on a page of the help of a field, or of a column of a table.
std::string field_anchor(const std::string& page, const std::string& field, const std::string& column = {});

}  // namespace covaria
