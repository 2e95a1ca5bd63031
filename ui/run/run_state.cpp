// Speed and remaining time of a run.
#include "ui/run/run_state.h"

namespace covaria::ui {

RunProgress progress_after(const Progress& progress, double seconds) {
    RunProgress shown{progress.trials_done, progress.trials_planned, 0.0, -1.0, progress.best};
    if (seconds > 0.0) shown.trials_per_second = static_cast<double>(progress.trials_done) / seconds;
    if (progress.trials_planned >= progress.trials_done && shown.trials_per_second > 0.0)
        shown.seconds_left =
            static_cast<double>(progress.trials_planned - progress.trials_done) / shown.trials_per_second;
    return shown;
}

}  // namespace covaria::ui
