#include "ui/scene_view/trial_words.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/name.h"
#include "core/propagation/engine.h"
#include "core/text/symbol.h"
#include "ui/models/number_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t most_in_line = 3;
constexpr std::size_t most_in_tip = 30;

struct Deviation {
    std::size_t input;
    double in_u;
};

QString name_of(const InputQuantity& input) {
    const QString symbol = to_qt(to_html(symbol_text(input.symbol)));
    return input.group.empty()
               ? symbol
               : QStringLiteral("%1 (%2)").arg(symbol, to_qt(said_name(input.group)).toHtmlEscaped());
}

QString in_u_of(double deviation) {
    return (deviation < 0 ? QString() : QStringLiteral("+")) + localized(format_decimals(deviation, 1)) +
           QStringLiteral(" <i>u</i>");
}

/// For each input: whether an output of the group depends on it.
std::vector<bool> inputs_of_group(const PreparedAnalysis& analysis, const std::string& group) {
    std::vector<bool> of_group(analysis.inputs.quantities.size(), false);
    const auto& propagation = analysis.propagated->propagation();
    const auto& outputs = analysis.model->outputs();
    for (std::size_t j = 0; propagation && j < outputs.size(); ++j)
        if (outputs[j].group == group)
            for (const Sensitivity& one : propagation->law.sensitivities[j])
                if (one.coefficient != 0.0) of_group[one.input] = true;
    return of_group;
}

}  // namespace

TrialWords trial_words(const PreparedAnalysis& analysis, const std::string& group, std::uint64_t trial) {
    const auto replayed = replay_trials(*analysis.propagated, analysis.options.seed, trial, 1);
    if (!replayed) return {};
    std::vector<Deviation> deviations;
    const InputSet& inputs = analysis.inputs;
    const std::vector<bool> counts = inputs_of_group(analysis, group);
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        if (!counts[i]) continue;
        const double u = standard_uncertainty_of(inputs, i);
        const double d = (replayed->inputs(static_cast<Eigen::Index>(i), 0) - estimate_of(inputs, i)) / u;
        if (std::isfinite(d)) deviations.push_back({i, d});
    }
    std::stable_sort(deviations.begin(), deviations.end(), [](const Deviation& a, const Deviation& b) {
        return std::abs(a.in_u) > std::abs(b.in_u);
    });
    TrialWords words;
    QStringList line, all;
    for (std::size_t k = 0; k < std::min(deviations.size(), most_in_tip); ++k) {
        const InputQuantity& input = inputs.quantities[deviations[k].input];
        const double x = replayed->inputs(static_cast<Eigen::Index>(deviations[k].input), 0);
        if (k < most_in_line) line << name_of(input) + QStringLiteral(" ") + in_u_of(deviations[k].in_u);
        all << QStringLiteral(
                   "<tr><td>%1&nbsp;</td><td align=right>%2 %3&nbsp;</td><td align=right>%4</td></tr>")
                   .arg(name_of(input), localized(format_significant(input.unit.from_si(x), 8)),
                        to_qt(input.unit.display()), in_u_of(deviations[k].in_u));
    }
    words.line = QObject::tr("<b>Trial %1</b>, inputs farthest from their estimates: %2")
                     .arg(localized(grouped_number(static_cast<double>(trial + 1), 0, user_numbers())),
                          line.join(QStringLiteral("; ")));
    words.all = QStringLiteral("<table>%1</table>").arg(all.join(QString()));
    return words;
}

}  // namespace covaria::ui
