// The state of the results of one analysis.
#pragma once

#include <QMetaType>
#include <QString>
#include <cstdint>
#include <optional>

#include "ui/run/run_backend.h"

namespace covaria::ui {

enum class RunState {
    out_of_date,
    running,
    up_to_date,
    failed,
    incomplete,  ///< nothing is wrong, but something that must be given is not given yet
};

/// Stage that the shown result has reached.
enum class ResultStage {
    none,
    first_order,  ///< law of propagation only; Monte Carlo is to follow
    preview,      ///< a few trials
    complete,     ///< everything that the analysis' options ask for
};

struct RunProgress {
    std::uint64_t trials_done = 0;
    std::uint64_t trials_planned = 0;  ///< 0 = not known
    double trials_per_second = 0.0;
    double seconds_left = -1.0;       ///< negative: not known
    std::optional<double> best = {};  ///< the smallest objective of a search so far
};

/// Speed and remaining time from what was done in `seconds`.
RunProgress progress_after(const Progress& progress, double seconds);

struct AnalysisStatus {
    RunState state = RunState::out_of_date;
    QString message = {};  ///< reason of a failure, or what is not given yet
    ResultStage stage = ResultStage::none;
    ResultPointer result = {};       ///< the newest there is; may be out of date
    PreparedPointer result_of = {};  ///< the analysis it was computed from
    PreparedPointer prepared = {};   ///< the analysis as it is now; null if it has problems
    bool has_same_numbers = false;   ///< `result_of` gives what `prepared` gives
    std::vector<Message> warnings = {};
    QString held = {};  ///< why it must not run: a text in one of its fields cannot be read
    /// Whether the result, whatever its stage, belongs to the analysis as it is now.
    bool is_of_present() const { return held.isEmpty() && result && prepared && has_same_numbers; }
    /// Whether it is also all that the analysis' options ask for: no preview. Only such a result counts.
    bool is_current() const { return is_of_present() && stage == ResultStage::complete; }
};

}  // namespace covaria::ui

Q_DECLARE_METATYPE(covaria::ui::RunProgress)
