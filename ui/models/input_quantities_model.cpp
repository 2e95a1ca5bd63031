// What was typed is shown at once; u follows when the analysis has been prepared again.
#include "ui/models/input_quantities_model.h"

#include <QFont>

#include "core/base/symbol.h"
#include "core/report/number_format.h"
#include "ui/document/quantity_edits.h"
#include "ui/document/quantity_text.h"
#include "ui/models/number_words.h"
#include "ui/models/roles.h"
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
                      analysis->inputs.quantities.size() == analysis_->inputs.quantities.size();
    if (!same) beginResetModel();
    analysis_ = std::move(analysis);
    if (!same)
        endResetModel();
    else if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, column_count - 1));
}

int InputQuantitiesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !analysis_ ? 0 : static_cast<int>(analysis_->inputs.quantities.size());
}

int InputQuantitiesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : column_count;
}

int InputQuantitiesModel::row_of(const std::string& symbol) const {
    const std::size_t found = analysis_ ? analysis_->inputs.find(symbol) : InputSet::npos;
    return found == InputSet::npos ? -1 : static_cast<int>(found);
}

bool InputQuantitiesModel::is_edited(int row) const {
    const std::string& symbol = quantity(row).symbol;
    return !(find_input_edit(document_.project(), analysis_->id, symbol) == InputEdit{.symbol = symbol});
}

QString InputQuantitiesModel::estimate_text(int row) const {
    const InputEdit edit = find_input_edit(document_.project(), analysis_->id, quantity(row).symbol);
    const Unit& unit = quantity(row).unit;
    if (edit.estimate)
        return number_text(converted(edit.estimate->value, edit.estimate->unit, unit), QLocale());
    const double value = unit.from_si(estimate_of(analysis_->inputs, static_cast<std::size_t>(row)));
    return number_text(QString::number(value, 'g', 12).toDouble(), QLocale());
}

QString InputQuantitiesModel::components_text(int row) const {
    QStringList parts;
    for (const Share& share : quantity(row).shares) {
        const UncertaintyComponent& component = analysis_->inputs.components[share.component];
        const double u = component.unit.interval_from_si(component.distribution.standard_uncertainty());
        parts << tr("%1 (%2, %3 %4)")
                     .arg(to_qt(component.name), to_qt(drawn_distribution(component).title()),
                          localized(format_significant(u, 2)), to_qt(component.unit.display()));
    }
    return parts.join("; ");
}

QString InputQuantitiesModel::text(int row, int column) const {
    switch (column) {
        case symbol_column:
            return to_qt(symbol_to_unicode(quantity(row).symbol));
        case name_column:
            return to_qt(quantity(row).name);
        case estimate_column:
            return estimate_text(row);
        case unit_column:
            return to_qt(quantity(row).unit.display());
        case uncertainty_column:
            return localized(format_significant(quantity(row).unit.interval_from_si(standard_uncertainty_of(
                                                    analysis_->inputs, static_cast<std::size_t>(row))),
                                                2));
        case components_column:
            return components_text(row);
        default:
            return {};
    }
}

QVariant InputQuantitiesModel::sort_value(int row, int column) const {
    const auto i = static_cast<std::size_t>(row);
    if (column == estimate_column) return estimate_of(analysis_->inputs, i);
    if (column == uncertainty_column) return standard_uncertainty_of(analysis_->inputs, i);
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
    if (role == Qt::ToolTipRole && is_edited(row)) return tr("Changed: differs from what the model says.");
    return {};
}

QVariant InputQuantitiesModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int row = index.row();
    const bool numeric = index.column() == estimate_column || index.column() == uncertainty_column;
    if (role == Qt::DisplayRole || role == Qt::EditRole) return text(row, index.column());
    if (role == sort_role) return sort_value(row, index.column());
    if (role == Qt::TextAlignmentRole)
        return QVariant((numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::CheckStateRole && index.column() == held_column)
        return find_input_edit(document_.project(), analysis_->id, quantity(row).symbol).held ? Qt::Checked
                                                                                              : Qt::Unchecked;
    return row_data(row, role);
}

QVariant InputQuantitiesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || section < 0) return {};
    if (orientation == Qt::Vertical) return section + 1;
    const QStringList heads{tr("Symbol"), tr("Input quantity"), tr("Estimate"),
                            tr("Unit"),   QStringLiteral("u"),  tr("Components of uncertainty"),
                            tr("Held")};
    return heads.value(section);
}

Qt::ItemFlags InputQuantitiesModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
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
                 held ? tr("Hold %1").arg(symbol) : tr("Release %1").arg(symbol),
                 [&](InputEdit& edit) { edit.held = held; });
    return true;
}

bool InputQuantitiesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
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
