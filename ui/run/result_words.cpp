#include "ui/run/result_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace covaria::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("covaria::ui::Results", text);
}

QString count(std::uint64_t trials) {
    return QLocale().toString(qulonglong(trials));
}

/// "Preview with 20 000 of 30 000 000 trials"
QString preview_words(const AnalysisStatus& status) {
    const EvaluationOptions& wanted = status.result_of->options;
    if (status.result->trials == 0) return tr("Preview by the law of propagation, without Monte Carlo");
    if (wanted.method == Method::adaptive)
        return tr("Preview with %1 trials, before the adaptive procedure").arg(count(status.result->trials));
    return tr("Preview with %1 of %2 trials").arg(count(status.result->trials), count(wanted.trials));
}

bool is_preview(const AnalysisStatus& status) {
    return status.stage != ResultStage::complete && status.result_of &&
           status.result_of->options.method != Method::first_order;
}

}  // namespace

QString result_words(const AnalysisStatus& status) {
    if (is_preview(status)) return preview_words(status);
    return status.result->trials == 0 ? tr("Law of propagation of uncertainty")
                                      : tr("Monte Carlo, %1 trials").arg(count(status.result->trials));
}

QString reservation(const AnalysisStatus& status) {
    if (!status.result || status.is_current()) return {};
    QString words = is_preview(status) ? preview_words(status) : QString();
    if (!status.is_of_present())
        words = tr("Out of date: of the project as it was") +
                (words.isEmpty() ? words : QStringLiteral("; ") + words.toLower());
    return words;
}

}  // namespace covaria::ui
