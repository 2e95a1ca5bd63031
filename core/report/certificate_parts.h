// The sections of a certificate; internal to core/report.
#pragma once

#include "core/report/certificate_words.h"
#include "core/report/report_parts.h"

namespace covaria::report_parts {

/// Adds the results of the analyses as result lines or, where there are many, as compact tables.
void add_certified_results(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// Adds the statement of what U, k and p are in these analyses.
void add_uncertainty_statement(Blocks& blocks, const std::vector<EvaluatedAnalysis>& analyses,
                               const DocumentLanguage& in);
/// Adds tables of conformity with the tolerances of the requirements; nothing without any.
void add_certified_conformity(Blocks& blocks, const ReportSource& source,
                              const std::vector<EvaluatedAnalysis>& analyses, const DocumentLanguage& in);
/// Adds what an amended certificate states otherwise than the one that it replaces: results, then texts;
/// nothing where the project does not have the statements of that one.
void add_changes(Blocks& blocks, const ReportSource& source, const std::vector<EvaluatedAnalysis>& shown,
                 const DocumentLanguage& in);
/// The lines of an address in one.
std::string in_one_line(const std::string& text);

}  // namespace covaria::report_parts
