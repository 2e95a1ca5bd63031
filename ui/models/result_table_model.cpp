// The choice of columns and rows of a result.
#include "ui/models/result_table_model.h"

#include <QGuiApplication>
#include <algorithm>

#include "core/propagation/requirements.h"
#include "core/views/result_columns.h"
#include "core/views/result_statement.h"
#include "ui/models/interval_mark.h"
#include "ui/models/roles.h"
#include "ui/theme/document_language.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

void ResultTableModel::set_result(std::shared_ptr<const UncertaintyResult> result, bool current,
                                  std::vector<RequirementResult> verdicts) {
    verdicts_ = std::move(verdicts);
    result_ = std::move(result);
    current_result_ = current;
    rebuild();
}

void ResultTableModel::set_group(const std::string& group) {
    group_ = group;
    rebuild();
}

void ResultTableModel::set_interval(Interval interval) {
    interval_ = interval;
    rebuild();
}

void ResultTableModel::set_filter(const QString& text, bool only_not_met) {
    words_ = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    only_not_met_ = only_not_met;
    rebuild();
}

bool ResultTableModel::is_wanted(std::size_t output) const {
    const OutputQuantity& quantity = result_->outputs[output].quantity;
    if (!group_.empty() && quantity.group != group_) return false;
    const QString text = to_qt(quantity.symbol) + QLatin1Char(' ') +
                         to_qt(to_unicode(symbol_text(quantity.symbol))) + QLatin1Char(' ') +
                         to_qt(quantity.name) + QLatin1Char(' ') + to_qt(quantity.group);
    const bool found = std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
    });
    return found && (!only_not_met_ ||
                     std::any_of(verdicts_.begin(), verdicts_.end(), [&](const RequirementResult& verdict) {
                         return verdict.output == output && !is_met(verdict);
                     }));
}

int ResultTableModel::row_of(std::size_t output_index) const {
    const auto found = std::find(shown_.begin(), shown_.end(), output_index);
    return found == shown_.end() ? -1 : static_cast<int>(found - shown_.begin());
}

void ResultTableModel::rebuild() {
    shown_.clear();
    for (std::size_t i = 0; result_ && i < result_->outputs.size(); ++i)
        if (is_wanted(i)) shown_.push_back(i);
    if (!result_) return set_contents({}, {}, {}, current_result_);
    set_contents(result_, results_table(*result_, shown_, verdicts_, language_of_window()), keys(),
                 current_result_);
}

std::vector<std::string> ResultTableModel::keys() const {
    std::vector<std::string> keys = {"group", "symbol", "name", "unit", "estimate", "u", "U"};
    for (std::string& column : RequirementCells::columns()) keys.push_back(std::move(column));
    if (!verdicts_.empty()) keys.insert(keys.end(), {"U/target", "met"});
    keys.insert(keys.end(), {"k", "nu_eff"});
    const bool symmetric = interval_ == Interval::symmetric;
    keys.insert(keys.end(),
                {symmetric ? "stated low" : "shortest low", symmetric ? "stated high" : "shortest high"});
    constexpr std::size_t most = 6;  // a network of many instruments would fill the table
    if (result_->contributors.size() <= most)
        for (std::string& key : contributor_keys(*result_)) keys.push_back(std::move(key));
    const bool has_trials = result_->trials > 0;  // else the first order is the result
    if (has_trials) keys.insert(keys.end(), {"estimate first order", "u first order", "U first order"});
    if (std::any_of(shown_.begin(), shown_.end(), [this](std::size_t j) {
            return result_->outputs[j].first_order.second_order_standard_uncertainty.has_value();
        }))
        keys.insert(keys.end(), {"u second order", "shift second order"});
    const bool is_validated = std::any_of(shown_.begin(), shown_.end(), [this](std::size_t j) {
        return result_->outputs[j].first_order.validation.has_value();
    });
    if (is_validated) keys.emplace_back("clause 8");
    return keys;
}

/// Words on the figures that decide whether the first order is validated.
QString ResultTableModel::deviations(std::size_t row) const {
    const auto said = [&](const char* of) { return to_qt(to_unicode(text_of(of, row))); };
    QString words = tr("Ends of the interval differ by %1 and %2 from those of Monte Carlo; tolerance %3")
                        .arg(said("d_low"), said("d_high"), said("delta"));
    if (result_->outputs[shown_[row]].first_order.validation->is_close)
        words += tr(". Other trials could give the other verdict: more of them decide.");
    return words;
}

const RequirementField* ResultTableModel::field_of(const QModelIndex& index) const {
    return index.isValid() ? requirements_.field_of(key(static_cast<std::size_t>(index.column()))) : nullptr;
}

Qt::ItemFlags ResultTableModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = ColumnTableModel::flags(index);
    return field_of(index) ? flags | Qt::ItemIsEditable : flags;
}

QVariant ResultTableModel::data(const QModelIndex& index, int role) const {
    const RequirementField* field = field_of(index);
    if (!field) return ColumnTableModel::data(index, role);
    const std::size_t output = output_of(index.row());
    if (const auto* refused = requirements_.refused(output, key(static_cast<std::size_t>(index.column())))) {
        if (role == Qt::DisplayRole || role == Qt::EditRole) return refused->text;
        if (role == typeset_role || role == exact_role) return {};
        if (role == Qt::ToolTipRole) return refused->complaint;
        if (role == Qt::BackgroundRole) return refused_ground();
        if (role == Qt::ForegroundRole) return Theme::of(QGuiApplication::palette()).tokens().red;
    }
    if (role == Qt::EditRole)
        return requirements_.text_of(result_->outputs[output].quantity, *field, units());
    return ColumnTableModel::data(index, role);
}

bool ResultTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!field_of(index) || role != Qt::EditRole) return false;
    const auto result = result_;  // another one comes with the project's change
    const std::string column = key(static_cast<std::size_t>(index.column()));
    if (requirements_.type(*result, output_of(index.row()), column, value.toString(), units())) return true;
    emit dataChanged(index, index);
    return false;
}

QVariant ResultTableModel::extra(std::size_t row, std::size_t column, int role) const {
    const OutputResult& output = result_->outputs[shown_[row]];
    const bool of_symmetric = key(column) == "U" || key(column) == "k";
    if (of_symmetric && is_stated_by_interval(output, *result_))
        if (const QVariant mark = interval_mark(role); mark.isValid()) return mark;
    if (role == group_role) return to_qt(output.quantity.group);
    if (role == id_role) return to_qt(output.quantity.symbol);
    if (role == index_role) return static_cast<qulonglong>(shown_[row]);
    if (role == Qt::ToolTipRole && key(column) == "clause 8" && output.first_order.validation)
        return deviations(row);
    if (role == Qt::ToolTipRole && output.monte_carlo) return to_qt(output.monte_carlo->normality.words);
    return {};
}

}  // namespace covaria::ui
