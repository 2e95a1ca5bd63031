// Joint coverage regions of the measurands of each group (JCGM 102 6.5, 7.7).
#include <algorithm>

#include "core/report/report_parts.h"
#include "core/text/numbers.h"
#include "core/views/result_columns.h"

namespace covaria::report_parts {

void add_regions(Blocks& blocks, const EvaluatedAnalysis& evaluated, const DocumentLanguage& in) {
    const UncertaintyResult& result = *evaluated.result;
    if (result.regions.empty()) return;
    blocks.push_back(HeadingBlock{2, in.say(tell<"Joint coverage regions">())});
    blocks.push_back(ParagraphBlock{
        in.say(tell<"Factors by which the standard uncertainties are to be multiplied so that all measurands "
                    "of a group lie in the region together with a probability of %1 (JCGM 102 6.5 and "
                    "7.7).">(percent_text(result.coverage_probability, in.numbers())))});
    const Table regions = regions_table(result);
    std::vector<std::string> keys = {"group in words", "symbols", "ellipsoid first order",
                                     "rectangle first order"};
    if (result.trials > 0) keys.insert(keys.end(), {"ellipsoid Monte Carlo", "rectangle Monte Carlo"});
    TableBuilder table("regions-" + evaluated.analysis->id, tell<"Factors of the coverage regions">(), in);
    table.all_of(regions, keys);
    if (std::ranges::any_of(result.regions, &CoverageRegion::singular))
        table.note(tell<"No ellipsoid is given where the covariance matrix of the group is singular.">());
    blocks.push_back(table.take());
}

}  // namespace covaria::report_parts
