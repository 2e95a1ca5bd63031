#include "ui/run/kept_states.h"

#include "ui/run/analysis_runner.h"
#include "ui/run/result_words.h"

namespace covaria::ui {

KeptStates::KeptStates(AnalysisRunner& runner, QObject* parent) : QObject(parent), runner_(runner) {}

bool KeptStates::can_keep(const QString& analysis) const {
    return runner_.made() && runner_.status(analysis).is_current();
}

void KeptStates::keep(const QString& analysis) {
    if (!can_keep(analysis)) return;
    const AnalysisStatus& status = runner_.status(analysis);
    kept_[analysis] = {status.result, std::make_shared<const Project>(runner_.made()->project()),
                       result_words(status), QDateTime::currentDateTime()};
    emit changed(analysis);
}

void KeptStates::discard(const QString& analysis) {
    if (kept_.erase(analysis) > 0) emit changed(analysis);
}

void KeptStates::clear() {
    while (!kept_.empty()) discard(QString(kept_.begin()->first));
}

const KeptState* KeptStates::find(const QString& analysis) const {
    const auto found = kept_.find(analysis);
    return found == kept_.end() ? nullptr : &found->second;
}

}  // namespace covaria::ui
