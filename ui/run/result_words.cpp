#include "ui/run/result_words.h"

#include <algorithm>
#include <cmath>

#include "core/result/result_line.h"
#include "core/text/numbers.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

QString count(std::uint64_t trials) {
    return to_qt(count_text(trials));
}

/// ", as good as 4 000 000 plain trials": how many plain trials would give such interval ends, by one digit,
/// which is all that the few batches of a preview know.
QString worth(const UncertaintyResult& result) {
    constexpr double most = 1e9;  // beyond, the rest is rounding
    const auto gain = least_gain(result);
    if (!gain || *gain < 1.5) return {};
    const double trials = std::min(most, *gain * static_cast<double>(result.trials));
    const double unit = std::pow(10.0, std::floor(std::log10(trials)));
    return tr(", as good as %1 plain trials")
        .arg(count(static_cast<std::uint64_t>(std::floor(trials / unit) * unit)));
}

/// "Preview with 12 000 of 30 000 000 trials, as good as 4 000 000 plain trials"
QString preview_words(const AnalysisStatus& status) {
    const EvaluationOptions& wanted = status.result_of->options;
    if (status.result->trials == 0) return tr("Preview by the law of propagation, without Monte Carlo");
    const QString done = count(status.result->trials), value = worth(*status.result);
    if (wanted.method == Method::adaptive)
        return tr("Preview with %1 trials, before the adaptive procedure").arg(done) + value;
    return tr("Preview with %1 of %2 trials").arg(done, count(wanted.trials)) + value;
}

bool is_preview(const AnalysisStatus& status) {
    return status.stage != ResultStage::complete && status.result_of &&
           status.result_of->options.method != Method::first_order;
}

}  // namespace

bool is_refused(const AnalysisStatus& status) {
    const bool waits = status.state == RunState::running || status.state == RunState::incomplete;
    return !status.held.isEmpty() || (!status.prepared && !waits);
}

QString result_words(const AnalysisStatus& status) {
    if (is_preview(status)) return preview_words(status);
    const UncertaintyResult& result = *status.result;
    QString words = tr("Law of propagation of uncertainty");
    if (result.trials > 0)
        words = (result.adaptive ? tr("Adaptive Monte Carlo, %1 trials") : tr("Monte Carlo, %1 trials"))
                    .arg(count(result.trials));
    if (leaves_out_degrees_of_freedom(result))
        words += tr("; k leaves degrees of freedom out (normal draws)");
    if (const auto k = result.fixed_coverage_factor)  // not that of the interval beside U
        words += tr(", chosen k = %1").arg(to_qt(typeset_number(format_typed(*k), user_numbers())));
    return words;
}

QString reservation(const AnalysisStatus& status) {
    if (!status.result || status.is_current()) return {};
    QString words = is_preview(status) ? preview_words(status) : QString();
    if (!status.is_of_present())
        words = tr("Out of date: of the project as it was") +
                (words.isEmpty() ? words : QStringLiteral("; ") + words.toLower());
    return words;
}

QString unprepared_words(const AnalysisStatus& status) {
    return status.state == RunState::incomplete
               ? tr("The analysis is not complete yet: what must still be given is listed under Problems.")
               : tr("The analysis has problems; they are listed under Problems.");
}

}  // namespace covaria::ui
