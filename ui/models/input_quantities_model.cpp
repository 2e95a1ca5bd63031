// Typed figures are shown at once; u follows when the analysis has been prepared again.
#include "ui/models/input_quantities_model.h"

#include <QFont>

#include "core/text/numbers.h"
#include "core/views/result_columns.h"
#include "ui/document/quantity_edits.h"
#include "ui/document/quantity_text.h"
#include "ui/models/number_words.h"
#include "ui/models/roles.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

InputQuantitiesModel::InputQuantitiesModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    connect(&document_, &Document::project_changed, this, [this] {
        if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, column_count - 1));
    });
}

void InputQuantitiesModel::set_analysis(std::shared_ptr<const PreparedAnalysis> analysis) {
    const bool same = analysis && analysis_ && analysis->id == analysis_->id &&
                      analysis->inputs.quantities.size() == analysis_->inputs.quantities.size() &&
                      analysis->linked.size() == analysis_->linked.size();
    if (!same) beginResetModel();
    analysis_ = std::move(analysis);
    list_rows();
    if (!same)
        endResetModel();
    else if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, column_count - 1));
}

void InputQuantitiesModel::list_rows() {
    own_.clear();
    linked_.clear();
    table_ = {};
    if (!analysis_) return;
    std::vector<InputRow> rows;
    for (std::size_t i = 0; i < analysis_->inputs.quantities.size(); ++i)
        if (analysis_->inputs.quantities[i].analysis.empty()) {
            own_.push_back(i);
            rows.push_back({{i}});
        }
    table_ = inputs_table(analysis_->inputs, std::move(rows));
    for (const LinkedInput& input : analysis_->linked)
        linked_.push_back({.symbol = input.symbol, .name = input.name, .unit = input.unit});
}

int InputQuantitiesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !analysis_ ? 0 : static_cast<int>(own_.size() + linked_.size());
}

double InputQuantitiesModel::estimate(int row) const {
    const auto i = static_cast<std::size_t>(row);
    return is_linked(row) ? analysis_->linked[i - own_.size()].estimate
                          : estimate_of(analysis_->inputs, own_[i]);
}

double InputQuantitiesModel::standard_uncertainty(int row) const {
    const auto i = static_cast<std::size_t>(row);
    return is_linked(row) ? analysis_->linked[i - own_.size()].standard_uncertainty
                          : standard_uncertainty_of(analysis_->inputs, own_[i]);
}

QString InputQuantitiesModel::linked_text(int row) const {
    const LinkedInput& input = analysis_->linked[static_cast<std::size_t>(row) - own_.size()];
    const QString from = to_qt(input.analysis_name.empty() ? input.analysis : input.analysis_name);
    QString output = to_qt(symbol_to_unicode(input.output.symbol));
    if (!input.output.group.empty()) output += QStringLiteral(" (%1)").arg(to_qt(input.output.group));
    return (input.linearised ? tr("from %1, linearised: %2") : tr("from %1: %2")).arg(from, output);
}

int InputQuantitiesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : column_count;
}

int InputQuantitiesModel::row_of(const std::string& symbol) const {
    for (int row = 0; row < rowCount(); ++row)
        if (quantity(row).symbol == symbol) return row;
    return -1;
}

bool InputQuantitiesModel::is_edited(int row) const {
    const std::string& symbol = quantity(row).symbol;
    return !is_linked(row) &&
           !(find_input_edit(document_.project(), analysis_->id, symbol) == InputEdit{.symbol = symbol});
}

QString InputQuantitiesModel::estimate_text(int row) const {
    const InputEdit edit = find_input_edit(document_.project(), analysis_->id, quantity(row).symbol);
    const Unit& unit = quantity(row).unit;
    if (edit.estimate)
        return number_text(converted(edit.estimate->value, edit.estimate->unit, unit), QLocale());
    const double value = unit.from_si(estimate(row));
    return number_text(QString::number(value, 'g', 12).toDouble(), QLocale());
}

/// The estimate with all digits that were typed, else as few as match its uncertainty.
QString InputQuantitiesModel::shown_estimate(int row) const {
    const InputEdit edit = find_input_edit(document_.project(), analysis_->id, quantity(row).symbol);
    const Unit& unit = quantity(row).unit;
    if (edit.estimate)
        return to_qt(grouped_digits(format_typed(converted(edit.estimate->value, edit.estimate->unit, unit)),
                                    user_numbers()));
    const double value = without_residue(unit.from_si(estimate(row)), unit);
    const std::string typed = format_typed(value),
                      matched = format_to_match(value, unit.interval_from_si(standard_uncertainty(row)));
    constexpr std::size_t more = 4;  // digits that somebody may well have typed
    return to_qt(grouped_digits(typed.size() <= matched.size() + more ? typed : matched, user_numbers()));
}

QString InputQuantitiesModel::components_text(int row) const {
    if (is_linked(row)) return linked_text(row);
    QStringList parts;
    for (const Share& share : quantity(row).shares) {
        const UncertaintyComponent& component = analysis_->inputs.components[share.component];
        const double u = component.unit.interval_from_si(component.distribution.standard_uncertainty());
        parts << tr("%1 (%2, %3)")
                     .arg(to_qt(component.name), core_text(drawn_distribution(component).title()),
                          localized(format_significant(u, 2)) + to_qt(unit_after_number(component.unit)));
    }
    return parts.join("; ");
}

QString InputQuantitiesModel::text(int row, int column) const {
    if (column == estimate_column) return estimate_text(row);
    if (column == components_column) return components_text(row);
    const Text shown = typeset(row, column);
    return to_qt(to_unicode(shown));
}

Text InputQuantitiesModel::typeset(int row, int column) const {
    if (is_linked(row)) return typeset_linked(row, column);
    const TableView view{{}, 2, language_of_window()};
    switch (column) {
        case symbol_column:
            return written(table_, table_["symbol"], std::size_t(row), view);
        case name_column:
            return written(table_, table_["name"], std::size_t(row), view);
        case unit_column:
            return written(table_, table_["unit"], std::size_t(row), view);
        case uncertainty_column:
            return written(table_, table_["u"], std::size_t(row), view);
        default:
            return {};
    }
}

Text InputQuantitiesModel::typeset_linked(int row, int column) const {
    const InputQuantity& shown = quantity(row);
    const double u = shown.unit.interval_from_si(standard_uncertainty(row));
    switch (column) {
        case symbol_column:
            return symbol_text(shown.symbol);
        case name_column:
            return Text(language_of_window().say(shown.name));
        case unit_column:
            return Text(shown.unit.display());
        case uncertainty_column:
            return Text(typeset_number(format_significant(u, 2), user_numbers()));
        default:
            return {};
    }
}

QVariant InputQuantitiesModel::sort_value(int row, int column) const {
    if (column == estimate_column) return estimate(row);
    if (column == uncertainty_column) return standard_uncertainty(row);
    return text(row, column);
}

QVariant InputQuantitiesModel::row_data(int row, int role) const {
    if (role == id_role) return to_qt(quantity(row).symbol);
    if (role == group_role) return to_qt(quantity(row).group);
    if (role == path_role) return to_qt(quantity(row).source);
    if (role == Qt::FontRole && is_edited(row)) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    if (role == Qt::ToolTipRole && is_linked(row))
        return tr("Evaluated in the other analysis, in every trial: edit it there.");
    if (role == Qt::ToolTipRole && is_edited(row)) return tr("Changed: differs from what the model says.");
    return {};
}

QVariant InputQuantitiesModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int row = index.row();
    const bool numeric = index.column() == estimate_column || index.column() == uncertainty_column;
    if (role == Qt::DisplayRole && index.column() == estimate_column) return shown_estimate(row);
    if (role == Qt::DisplayRole || role == Qt::EditRole) return text(row, index.column());
    if (role == typeset_role && index.column() == symbol_column)
        return QVariant::fromValue(typeset(row, index.column()));
    if (role == sort_role) return sort_value(row, index.column());
    if (role == Qt::TextAlignmentRole)
        return QVariant((numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() == components_column && !is_linked(row))
        return components_text(row);
    if (role == Qt::CheckStateRole && index.column() == held_column && !is_linked(row))
        return find_input_edit(document_.project(), analysis_->id, quantity(row).symbol).held ? Qt::Checked
                                                                                              : Qt::Unchecked;
    return row_data(row, role);
}

QVariant InputQuantitiesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role == Qt::TextAlignmentRole && orientation == Qt::Horizontal) {
        const bool numeric = section == estimate_column || section == uncertainty_column;
        return QVariant((numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole || section < 0) return {};
    if (orientation == Qt::Vertical) return section + 1;
    const QStringList heads{tr("Symbol"),        tr("Input quantity"), tr("Estimate"), tr("Unit"),
                            QStringLiteral("u"), tr("Components"),     tr("Constant")};
    return heads.value(section);
}

Qt::ItemFlags InputQuantitiesModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (index.isValid() && is_linked(index.row())) return flags;
    if (index.column() == estimate_column) return flags | Qt::ItemIsEditable;
    return index.column() == held_column ? flags | Qt::ItemIsUserCheckable : flags;
}

bool InputQuantitiesModel::set_estimate(int row, const QString& typed) {
    const auto quantity_typed = parse_quantity(typed, quantity(row).unit, QLocale());
    if (!quantity_typed) return false;
    change_input(document_, analysis_->id, quantity(row).symbol,
                 tr("Change estimate of %1").arg(text(row, symbol_column)),
                 [&](InputEdit& edit) { edit.estimate = *quantity_typed; });
    return true;
}

bool InputQuantitiesModel::set_held(int row, bool held) {
    const QString symbol = text(row, symbol_column);
    change_input(document_, analysis_->id, quantity(row).symbol,
                 held ? tr("Keep %1 constant").arg(symbol) : tr("Let %1 vary").arg(symbol),
                 [&](InputEdit& edit) { edit.held = held; });
    return true;
}

bool InputQuantitiesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || is_linked(index.row())) return false;
    if (role == Qt::EditRole && index.column() == estimate_column)
        return set_estimate(index.row(), value.toString());
    if (role == Qt::CheckStateRole && index.column() == held_column)
        return set_held(index.row(), value.toInt() == Qt::Checked);
    return false;
}

void InputQuantitiesModel::reset_edits(int row) {
    change_input(document_, analysis_->id, quantity(row).symbol,
                 tr("Reset %1 to the model's values").arg(text(row, symbol_column)),
                 [](InputEdit& edit) { edit = {.symbol = edit.symbol}; });
}

}  // namespace covaria::ui
