// The sections of a report and the words they share; internal to core/report.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/report/report.h"
#include "core/text/table.h"

namespace covaria::report_parts {

using Blocks = std::vector<ReportBlock>;

// One function per section; each appends its headings and blocks. Headings and captions are numbered at the
// end.
void add_title(Blocks& blocks, const ReportSource& source);
void add_models(Blocks& blocks, const ReportSource& source);
void add_setup(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
void add_inputs(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
/// Inputs that are outputs of other analyses; nothing without any.
void add_links(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// `shown` are the assets whose evaluation the report has already.
void add_assets(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated,
                std::set<std::string>& shown);
inline constexpr std::size_t most_budget_rows = 24;  ///< further components are summed
void add_budgets(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in,
                 std::size_t most_rows = most_budget_rows);
void add_results(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
/// Target uncertainties, conformity; nothing without requirements.
void add_requirements(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated);
/// Nothing where they were not asked for.
void add_sobol(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// What remains with everything of one contributor held, and what it gives alone; nothing with fewer than
/// two.
void add_contributors(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// What the model says about its set-up beside the outputs.
void add_model_evaluation(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_comparison(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
/// Nothing without earlier results.
void add_before(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_regions(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_distributions(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_scene(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_correlation(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_studies(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_designs(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in);
void add_notes(Blocks& blocks, const ReportSource& source);
void add_provenance(Blocks& blocks, const ReportSource& source);

/// Outputs by group against U, when there are several groups with the same measurands; else nothing.
std::optional<TableBlock> summary_matrix(const UncertaintyResult& result, const Message& title,
                                         const DocumentLanguage& in);
/// The result line of the given outputs. `explained`: words beside it say that the degrees of freedom are of
/// first order, and k of Monte Carlo is not taken for them; without words they are left out then.
TableBlock results_block(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                         const Message& title, const DocumentLanguage& in, bool explained = true);
TableBlock setup_table(const FieldSpec& field, const SetupTable& table, const ReportSource& source);
std::string setup_text(const FieldSpec& field, const SetupValue& value, const ReportSource& source);
/// Scalar fields as facts, tables as tables, under the headings of their sections; `equations` where the
/// field stands in which they are typed, without one first.
void add_setup_fields(Blocks& blocks, const SetupSchema& schema, const Setup& setup,
                      const ReportSource& source, const Blocks& equations = {});

/// A chart; its id, which names files, begins with the analysis' id and so is unique in a report.
PlotBlock figure(PlotSpecification plot, const EvaluatedAnalysis& evaluated, std::string caption);
/// With its title as caption.
PlotBlock titled_figure(PlotSpecification plot, const EvaluatedAnalysis& evaluated);

/// One paragraph per line of a note.
void add_paragraphs(Blocks& blocks, const std::string& text);

// --- words and selections (report_words.cpp)

/// Grows a table of the document, in a language that outlives it: heads are said as they are added.
class TableBuilder {
public:
    TableBuilder(std::string id, const Message& title,
                 const DocumentLanguage& in = DocumentLanguage::english());
    Column& text(const Message& head, bool symbol_cells = false);
    /// Its role is set on the column that is returned. `key`: by which the rules of others find it.
    Column& number(const Message& head, const std::string& key = {});
    Column& symbol(const std::string& head, const std::string& key = {});
    Column& fixed(const Message& head, int decimals);
    /// Those columns of a table, as print has them, with what the rules of their numbers read.
    void columns(const Table& table, const std::vector<std::string>& keys);
    /// A row of the table that the columns are from.
    void row_of(const Table& table, std::size_t row);
    /// Those columns of a table and all its rows.
    void all_of(const Table& table, const std::vector<std::string>& keys);
    /// Those columns of the table of results, and the rows of these outputs under sub-heads of their groups.
    void results(const UncertaintyResult& result, const std::vector<std::size_t>& outputs,
                 const std::vector<std::string>& keys);
    void row(std::vector<Cell> cells) { block_.table.row(std::move(cells)); }
    /// A row that only the columns of these keys have something for.
    void row_with(std::map<std::string, Cell> cells);
    void subhead(const Message& text) { block_.table.subhead(in_.say(text)); }
    void note(const Message& text) { block_.table.notes.push_back(in_.say(text)); }
    TableBlock take() { return std::move(block_); }

private:
    Column& add(const std::string& key, Text head);
    const DocumentLanguage& in_;
    TableBlock block_;
};

std::string project_fingerprint(const ReportSource& source);  ///< of the evaluated project
std::string type_text(EvaluationType type);                   ///< "A", "B"
std::string unit_text(const Unit& unit);                      ///< "mm", "1" for the unit one
std::string id_part(const std::string& text);  ///< of a block's id: a part of a file's name in small letters
Text output_text(const OutputQuantity& quantity, const DocumentLanguage& in = {});  ///< "x (pose 7)"
Message output_label(const OutputQuantity& quantity);                               ///< likewise, Unicode
Measured value_in(const Unit& unit, double si);
Measured interval_in(const Unit& unit, double si);  ///< differences and uncertainties

Message contributor_title(const ContributorResult& result);  ///< its name; "the set-up" if it has none
bool is_measurand(const OutputResult& output);
/// Groups that have measurands, in order.
std::vector<Name> measurand_groups(const UncertaintyResult& result);
std::vector<std::size_t> measurands_of(const UncertaintyResult& result, const std::string& group);
bool groups_alike(const UncertaintyResult& result, const std::vector<Name>& groups);
/// Those whose measurands have the symbols and units of the first group's: what can be compared with it.
std::vector<Name> groups_like_the_first(const UncertaintyResult& result);
/// Groups that are shown: all if there are at most two, else of those like the first the one with the largest
/// U, measured for each symbol by its mean over the groups.
std::vector<Name> groups_in_full(const UncertaintyResult& result);

}  // namespace covaria::report_parts
