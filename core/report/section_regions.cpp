// Joint coverage regions of the measurands of each group (JCGM 102 6.5, 7.7).
#include "core/report/report_parts.h"

namespace covaria::report_parts {
namespace {

TableCell factor(const std::optional<double>& value) {
    return value ? TableCell(*value) : TableCell{};
}

}  // namespace

void add_regions(Blocks& blocks, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.regions.empty()) return;
    blocks.push_back(HeadingBlock{2, "Joint coverage regions"});
    blocks.push_back(
        ParagraphBlock{"Factors by which the standard uncertainties are to be multiplied so that all "
                       "measurands of a group lie in the "
                       "region together with a probability of " +
                       percent_text(result.coverage_probability) + " (JCGM 102 6.5 and 7.7)."});
    TableBuilder table("regions-" + evaluated.analysis->id, "Factors of the coverage regions");
    table.text("Group");
    table.number("Quantities");
    table.fixed("ellipsoid, law of prop.", 3);
    table.fixed("rectangle, law of prop.", 3);
    const bool trials = result.trials > 0;
    if (trials) table.fixed("ellipsoid, Monte Carlo", 3);
    if (trials) table.fixed("rectangle, Monte Carlo", 3);
    bool singular = false;
    for (const CoverageRegion& region : result.regions) {
        std::vector<TableCell> row = {region.group.empty() ? "all" : region.group,
                                      static_cast<double>(region.outputs.size()),
                                      region.singular ? TableCell{} : TableCell(region.ellipsoid_first_order),
                                      region.rectangle_first_order};
        if (trials) row.push_back(region.singular ? TableCell{} : factor(region.ellipsoid_monte_carlo));
        if (trials) row.push_back(factor(region.rectangle_monte_carlo));
        table.row(std::move(row));
        singular = singular || region.singular;
    }
    if (singular) table.note("No ellipsoid is given where the covariance matrix of the group is singular.");
    blocks.push_back(table.take());
}

}  // namespace covaria::report_parts
