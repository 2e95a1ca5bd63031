// The sections of a report and the words they share; internal to core/report.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/report/report.h"
#include "core/report/table_builder.h"
#include "core/text/table.h"

namespace covaria::report_parts {

using namespace result_words;

using Blocks = std::vector<ReportBlock>;

// Each section has a function, which appends its headings and blocks. Headings and captions are numbered at
// the end.
/// Adds the title block: facts, notes, failures, and results at a glance.
void add_title(Blocks& blocks, const ReportSource& source);
/// The same without the results.
void add_facts(Blocks& blocks, const ReportSource& source);
void add_models(Blocks& blocks, const ReportSource& source);
void add_setup(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
void add_inputs(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
/// Adds the inputs that are outputs of other analyses; nothing without any.
void add_links(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// `shown` are the assets whose evaluation the report has already.
void add_assets(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated,
                std::set<std::string>& shown);
inline constexpr std::size_t most_budget_rows = 24;  ///< further components are summed
void add_budgets(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in,
                 std::size_t most_rows = most_budget_rows);
void add_results(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
/// Adds target uncertainties and conformity; nothing without requirements.
void add_requirements(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
/// Adds the Sobol indices; nothing where they were not asked for.
void add_sobol(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// Adds what remains with everything of one contributor held, and what it gives alone; nothing with fewer
/// than two.
void add_contributors(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// Adds the model's evaluation of its set-up beside the outputs.
void add_model_evaluation(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_comparison(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// Adds the earlier results; nothing without any.
void add_before(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_regions(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_distributions(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_scene(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_correlation(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_studies(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_designs(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_notes(Blocks& blocks, const ReportSource& source);
void add_provenance(Blocks& blocks, const ReportSource& source);
/// Adds who prepared, checked and released the project and the digest; of a draft, that it is one, and what
/// changed since a release. Nothing where no review is stated.
void add_review(FactsBlock& facts, const Project& project, const DocumentLanguage& in);

/// Outputs by group against U, when there are several groups with the same measurands; else nothing.
std::optional<TableBlock> summary_matrix(const UncertaintyResult& result, const Message& title,
                                         const DocumentLanguage& in);
/// The result line of the given outputs. `explained` says that words beside it tell that the degrees of
/// freedom are of first order, and k of Monte Carlo is not taken for them; without words they are left out.
TableBlock results_block(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                         const Message& title, const DocumentLanguage& in, bool explained = true);
TableBlock setup_table(const FieldSpec& field, const SetupTable& table, const ReportSource& source);
std::string setup_text(const FieldSpec& field, const SetupValue& value, const ReportSource& source);
/// Adds scalar fields as facts and tables as tables, under the headings of their sections. The blocks
/// `equations` stand in place of the field in which they are typed, or first where there is none.
void add_setup_fields(Blocks& blocks, const SetupSchema& schema, const Setup& setup,
                      const ReportSource& source, const Blocks& equations = {});

/// A chart; its id, which names files, begins with the analysis' id and so is unique in a report.
PlotBlock figure(PlotSpecification plot, const EvaluatedAnalysis& evaluated, std::string caption);
/// A chart with its title as caption.
PlotBlock titled_figure(PlotSpecification plot, const EvaluatedAnalysis& evaluated);

/// Adds a paragraph for each line of a note.
void add_paragraphs(Blocks& blocks, const std::string& text);

std::string project_fingerprint(const ReportSource& source);  ///< fingerprint of the evaluated project
}  // namespace covaria::report_parts
