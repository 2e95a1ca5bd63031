// The inputs of one trial of a Monte Carlo run, in words.
#pragma once

#include <QString>
#include <cstdint>

#include "core/made/prepared_analysis.h"

namespace covaria::ui {

struct TrialWords {
    QString line;  ///< HTML: the inputs that were farthest from their estimates, in their u
    QString all;   ///< HTML: more of them, with their values, for a tip
};

/// Words on a trial of the run with the analysis' seed: inputs that outputs of `group` depend on, to first
/// order. Empty where the trial cannot be made again.
TrialWords trial_words(const PreparedAnalysis& analysis, const std::string& group, std::uint64_t trial);

}  // namespace covaria::ui
