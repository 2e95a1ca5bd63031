// What an analysis says in one line, for the strip above the stage and for the clipboard: the statements of
// certificates, chosen and never rounded anew.
#pragma once

#include <string>
#include <vector>

#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"
#include "core/text/text.h"

namespace covaria::ui {

struct Answer {
    Text value;  ///< "L = (50.000 78 ± 0.000 41) mm"; of a group "U = 0.051 mm (y)", of each kind its largest
    Text coverage;                     ///< "k = 2.00, p = 95 %"
    std::vector<std::size_t> outputs;  ///< that it is about
    std::string statements;            ///< of all of them, a line each
};

/// Where outputs belong to groups (points, poses) their largest uncertainties are the answer, else the output
/// that is looked at. `output`: index into the result's.
Answer answer_of(const UncertaintyResult& result, std::size_t output, const DocumentLanguage& in,
                 const DisplayUnits& units, int digits);

struct VerdictWords {
    bool met = true;
    Text words;  ///< empty: nothing is required
};
/// Of the requirements on outputs that the answer is about: "not met: y, z".
VerdictWords verdict_words(const UncertaintyResult& result, const Answer& answer,
                           const std::vector<RequirementResult>& verdicts);

}  // namespace covaria::ui
