// Tables of results, each of one analysis, joined.
#include "ui/models/all_results_model.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

#include "core/views/result_columns.h"
#include "core/views/result_statement.h"
#include "ui/models/interval_mark.h"
#include "ui/models/roles.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void AllResultsModel::set_analyses(std::vector<ShownAnalysis> analyses) {
    analyses_ = std::move(analyses);
    rebuild();
}

void AllResultsModel::set_filter(const QString& text, bool only_not_met) {
    words_ = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    only_not_met_ = only_not_met;
    rebuild();
}

bool AllResultsModel::is_wanted(const ShownAnalysis& analysis, std::size_t output) const {
    const OutputQuantity& quantity = analysis.result->outputs[output].quantity;
    if (quantity.role != OutputRole::measurand) return false;
    const QStringList said{to_qt(analysis.name), to_qt(quantity.symbol),
                           to_qt(to_unicode(symbol_text(quantity.symbol))), to_qt(quantity.name),
                           to_qt(quantity.group)};
    const QString text = said.join(QLatin1Char(' '));
    const bool found = std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
    });
    return found && (!only_not_met_ || std::any_of(analysis.verdicts.begin(), analysis.verdicts.end(),
                                                   [&](const RequirementResult& verdict) {
                                                       return verdict.output == output && !is_met(verdict);
                                                   }));
}

std::optional<double> AllResultsModel::coverage_probability() const {
    const double p = analyses_.front().result->coverage_probability;
    const bool one = std::all_of(analyses_.begin(), analyses_.end(), [p](const ShownAnalysis& analysis) {
        return analysis.result->coverage_probability == p;
    });
    return one ? std::optional(p) : std::nullopt;
}

Table AllResultsModel::joined(const std::vector<std::vector<std::size_t>>& outputs) const {
    struct Part {
        std::string name, state;
        Table table;
    };
    auto parts = std::make_shared<std::vector<Part>>();
    for (std::size_t i = 0; i < analyses_.size(); ++i)
        parts->push_back({analyses_[i].name, to_std(analyses_[i].state),
                          results_table(*analyses_[i].result, outputs[i], analyses_[i].verdicts)});
    auto rows = std::make_shared<const std::vector<Row>>(rows_);
    Table all{"all-results", "Results of all analyses", rows->size()};
    all.add("analysis", [=](std::size_t row) -> Cell { return (*parts)[(*rows)[row].analysis].name; })
        .window(to_std(tr("Analysis")));
    for (const char* key : {"group", "symbol", "name", "estimate", "rounding", "U", "unit", "k", "stated low",
                            "stated high", "target", "U/target", "met"}) {
        Column column = parts->front().table[key];
        column.unit.reset();  // each row has its own
        column.cell = Cells([=](std::size_t row) {
            return (*parts)[(*rows)[row].analysis].table.cell((*rows)[row].row, key);
        });
        all.columns.push_back(std::move(column));
    }
    const auto limit = [&](const char* key, const std::string& head) {
        const auto column = std::ranges::find(all.columns, key, &Column::key);
        column->window(head, to_std(tr("Coverage interval of the result line"))).estimate_of("rounding");
    };
    const IntervalHeads heads = interval_heads(coverage_probability(), language_of_window());
    limit("stated low", heads.low);
    limit("stated high", heads.high);
    all.add("state", [=](std::size_t row) -> Cell { return (*parts)[(*rows)[row].analysis].state; })
        .window(to_std(tr("State")));
    return all;
}

void AllResultsModel::rebuild() {
    rows_.clear();
    std::vector<std::vector<std::size_t>> outputs(analyses_.size());
    bool required = false;
    for (std::size_t i = 0; i < analyses_.size(); ++i) {
        required = required || !analyses_[i].verdicts.empty();
        for (std::size_t j = 0; j < analyses_[i].result->outputs.size(); ++j) {
            if (!is_wanted(analyses_[i], j)) continue;
            rows_.push_back({i, outputs[i].size(), j});
            outputs[i].push_back(j);
        }
    }
    if (analyses_.empty()) return set_contents({}, {}, {}, true);
    std::vector<std::string> keys{"analysis", "group", "symbol", "name", "estimate", "U", "unit"};
    if (required) keys.insert(keys.end(), {"target", "U/target", "met"});
    keys.insert(keys.end(), {"stated low", "stated high", "k", "state"});
    auto owner = std::make_shared<const std::vector<ShownAnalysis>>(analyses_);
    set_contents(owner, joined(outputs), std::move(keys), true);
}

AllResultsModel::Place AllResultsModel::place_of(int row) const {
    const Row& at = rows_[static_cast<std::size_t>(row)];
    const ShownAnalysis& analysis = analyses_[at.analysis];
    return {analysis.id, analysis.result->outputs[at.output].quantity.group, at.output};
}

QVariant AllResultsModel::extra(std::size_t row, std::size_t column, int role) const {
    const ShownAnalysis& analysis = analyses_[rows_[row].analysis];
    if (role == Qt::ForegroundRole && !analysis.of_present)
        return QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
    const bool of_symmetric = key(column) == "U" || key(column) == "k";
    if (of_symmetric && is_stated_by_interval(analysis.result->outputs[rows_[row].output], *analysis.result))
        if (const QVariant mark = interval_mark(role); mark.isValid()) return mark;
    if (role == Qt::ToolTipRole) return tr("Double click: goes to the analysis");
    return {};
}

}  // namespace covaria::ui
