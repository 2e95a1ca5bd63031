// The impact of a certificate as people and files have it.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"
#include "core/impact/impact.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// What was asked, in words: what is replaced, by what, where was looked.
struct ImpactWords {
    std::string old_figures, new_figures;
    std::vector<std::string> folders;
};

/// A row for each measurand that the certificate reaches. It reads the impact, which must live.
Table impact_table(const Impact& impact);

/// How many files, results, changes and verdicts, in sentences.
std::vector<Message> impact_sentences(const Impact& impact);

/// Facts, sentences, the table without results that do not change, the documents to amend, what could not be
/// evaluated.
ReportDocument build_impact(const ImpactWords& words, const Impact& impact, const DocumentLanguage& in = {});

}  // namespace covaria
