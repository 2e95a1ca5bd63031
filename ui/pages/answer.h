// The result of an analysis in one line, for the strip above the stage and for the clipboard: the statements
// of certificates, chosen and never rounded anew.
#pragma once

#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"
#include "core/text/text.h"
#include "core/views/decisions.h"

namespace covaria::ui {

struct Answer {
    Text value;  ///< "L = (50.000 78 ± 0.000 41) mm"; of a group "U = 0.051 mm (y)", of each kind its largest
    Text coverage;                     ///< "k = 2.00, p = 95 %"
    std::vector<std::size_t> outputs;  ///< the answer is about these
    std::string statements;            ///< one line for each of them
};

/// Answer of an analysis: the largest uncertainties of the group of `output` (a point, a pose), else that
/// output itself. `output`: index into the result's.
Answer answer_of(const UncertaintyResult& result, std::size_t output, const DocumentLanguage& in,
                 const DisplayUnits& units, int digits);

struct VerdictWords {
    bool met = true;
    bool is_open = false;  ///< nothing is missed, and something is not decided
    Text words;            ///< empty: nothing is required
    Text detail;           ///< "U 61 ≤ 70 nm"; empty: there is not one output with a target uncertainty
};
/// Verdict of the requirements on outputs that the answer is about: "not met: y, z".
VerdictWords verdict_words(const UncertaintyResult& result, const Answer& answer,
                           const std::vector<RequirementResult>& verdicts, const DocumentLanguage& in,
                           const DisplayUnits& units);

/// Verdict of a sheet of tests on itself: "not met: 2 of 12".
VerdictWords decision_words(const std::vector<DecidedRow>& decisions);

}  // namespace covaria::ui
