// Words on how a shown result came about, and whether it is the result.
#pragma once

#include <QString>

#include "ui/run/run_state.h"

namespace covaria::ui {

/// "Monte Carlo, 20 000 trials"; of a preview, what it is a preview of.
QString result_words(const AnalysisStatus& status);
/// Warning wherever a part of the result goes that is no report; empty for a current result.
QString reservation(const AnalysisStatus& status);

/// Whether a field is wrong, so that the result shown is of the state before, and is faint.
bool is_refused(const AnalysisStatus& status);
inline constexpr double opacity_of_last = 0.45;

/// Why an analysis that is not prepared shows nothing: it has problems, or something is not given yet.
QString unprepared_words(const AnalysisStatus& status);

}  // namespace covaria::ui
