// The impact of a certificate as people and files have it.
#pragma once

#include <string>
#include <vector>

#include "core/document/report_document.h"
#include "core/impact/impact.h"
#include "core/text/document_language.h"
#include "core/text/table.h"

namespace covaria {

/// Name of a file with that of its folder, which tells equal names apart: "2025/customer-b.covaria".
std::string file_in_folder(const std::string& path);

/// "b.covaria has figures of 2026-7 (2026/a.covaria)".
Message follower_words(const ImpactFollower& follower);

/// The files as a text file has them, one on a line.
std::string file_list(const std::vector<std::string>& files);

/// The table of an impact, with a row for each measurand that the certificate reaches. It reads the impact,
/// which must outlive it.
Table impact_table(const Impact& impact);

/// Sentences that count the files, results, changes and verdicts.
std::vector<Message> impact_sentences(const Impact& impact);

/// The document of an impact: facts, sentences, the table without results that do not change, the documents
/// to amend, and the files that could not be evaluated.
ReportDocument build_impact(const ImpactWords& words, const Impact& impact, const DocumentLanguage& in = {});

}  // namespace covaria
