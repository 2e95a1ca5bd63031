// Input quantities and where their uncertainties come from; quantities with equal components share a row.
#include <algorithm>
#include <map>

#include "core/report/report_parts.h"
#include "core/text/numbers.h"
#include "core/views/result_columns.h"

namespace covaria::report_parts {
namespace {

constexpr std::size_t listed_one_by_one = 24;  // up to this number every quantity has a row of its own
constexpr std::size_t smallest_collapsed = 5;  // number of quantities with equal components that share a row

/// The signature of a quantity, which two of them must have in common to share a row: their components with
/// their uncertainties or, where several components make one (the axes of a tilted frame), the names of the
/// components and the uncertainty that they combine to.
std::string signature(const InputSet& inputs, std::size_t index) {
    const InputQuantity& quantity = inputs.quantities[index];
    std::string text = quantity.unit.text() + "\n" +
                       (quantity.combination == Combination::arithmetic ? "arithmetic" : "quadrature");
    const bool combined = quantity.shares.size() > 1;
    if (combined) text += "\n" + format_significant(standard_uncertainty_of(inputs, index), 4);
    for (const Share& share : quantity.shares) {
        const UncertaintyComponent& c = inputs.components[share.component];
        text += "\n" + c.name.english() + "|" + std::string(c.distribution.kind()) + "|" +
                c.origin.english() + "|" + format_exact(c.degrees_of_freedom) + type_text(c.type) +
                (c.held ? "h" : "");
        if (!combined)
            text += "|" + format_exact(std::abs(share.factor) * c.distribution.standard_uncertainty());
    }
    return text;
}

using Members = std::vector<std::size_t>;

/// The quantities of each row of the table, in order of first appearance.
std::vector<Members> rows_of(const InputSet& inputs) {
    std::map<std::string, Members> alike;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) alike[signature(inputs, i)].push_back(i);
    std::vector<Members> rows;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        const Members& members = alike[signature(inputs, i)];
        const bool collapse =
            inputs.quantities.size() > listed_one_by_one && members.size() >= smallest_collapsed;
        if (!collapse)
            rows.push_back({i});
        else if (members.front() == i)
            rows.push_back(members);
    }
    return rows;
}

/// Adds the row of quantities and, where it is one whose components combine, a row for each of these.
void add_rows(const InputSet& inputs, const Members& members, std::vector<InputRow>& rows) {
    rows.push_back({members});
    const std::size_t shares = inputs.quantities[members.front()].shares.size();
    if (members.size() > 1) return;  // their shares differ from one to the next, as the CSV table shows
    for (std::size_t k = 0; shares > 1 && k < shares; ++k) rows.push_back({members, k, true});
}

/// Adds the stated correlations; those of quantities that add their components are in the rows of these.
void add_correlations(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const InputSet& inputs = evaluated.result->inputs;
    if (inputs.correlations.empty()) return;
    const Table all = input_correlations_table(inputs, inputs.correlations);
    static const std::vector<std::string> keys = {"label", "other label", "r"};
    TableBuilder table("input-correlations-" + evaluated.analysis->id,
                       tell<"Correlation coefficients of components">(), in);
    table.all_of(all, keys);
    blocks.push_back(table.take());
}

void add_quantity_notes(Blocks& blocks, const InputSet& inputs, const AnalysisEntry& entry,
                        const DocumentLanguage& in) {
    TableBuilder table("input-notes-" + entry.id, tell<"Notes on input quantities">(), in);
    table.text(tell<"Symbol">(), true);
    table.text(tell<"Notes">());
    bool some = false;
    for (const QuantityNotes& notes : entry.quantity_notes)
        if (inputs.find(notes.symbol) != InputSet::npos) {
            table.row({notes.symbol, notes.notes});
            some = true;
        }
    if (some) blocks.push_back(table.take());
}

}  // namespace

void add_inputs(Blocks& blocks, const ReportSource& source, const EvaluatedAnalysis& evaluated) {
    const DocumentLanguage& in = source.in;
    const InputSet& inputs = evaluated.result->inputs;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Input quantities">())});
    const std::vector<Members> rows = rows_of(inputs);
    std::vector<InputRow> lines;
    for (const Members& members : rows) add_rows(inputs, members, lines);
    const Table all = inputs_table(inputs, std::move(lines));
    static const std::vector<std::string> keys = {"symbol",    "name",
                                                  "estimate",  "unit",
                                                  "u",         "row distribution",
                                                  "row type",  "row degrees of freedom",
                                                  "row origin"};
    TableBuilder table("inputs-" + evaluated.analysis->id,
                       tell<"Input quantities and the origin of their uncertainties">(), in);
    table.all_of(all, keys);
    if (rows.size() < inputs.quantities.size())
        table.note(
            tell<"%1 input quantities; many with equal components share a row. The CSV table of inputs "
                 "lists every one with its estimate.">(inputs.quantities.size()));
    blocks.push_back(table.take());
    if (const AnalysisEntry* entry = source.made.project().find_analysis(evaluated.analysis->id))
        add_quantity_notes(blocks, inputs, *entry, in);
    add_correlations(blocks, evaluated, in);
}

}  // namespace covaria::report_parts
