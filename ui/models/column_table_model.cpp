// Read-only tables.
#include "ui/models/column_table_model.h"

#include <QGuiApplication>
#include <QPalette>
#include <cmath>

#include "ui/models/roles.h"
#include "ui/theme/core_text.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// SI, so that rows in different units compare.
std::optional<double> sort_number(const Cell& cell) {
    if (const auto* number = std::get_if<Measured>(&cell)) return number->si;
    if (const auto* number = std::get_if<Quantity>(&cell)) return number->si();
    return std::holds_alternative<std::monostate>(cell) ? std::optional(std::nan("")) : std::nullopt;
}

}  // namespace

int ColumnTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || keys_.empty() ? 0 : static_cast<int>(table_.rows);
}

int ColumnTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(keys_.size());
}

QVariant ColumnTableModel::extra(std::size_t, std::size_t, int) const {
    return {};
}

QVariant ColumnTableModel::row_title(std::size_t row, int role) const {
    return role == Qt::DisplayRole ? QVariant(QString::number(row + 1)) : QVariant();
}

QVariant ColumnTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const auto row = static_cast<std::size_t>(index.row());
    const Column& of = column(index.column());
    switch (role) {
        case sort_role:
            if (const auto number = sort_number(of.cell(row))) return *number;
            [[fallthrough]];
        case Qt::DisplayRole:
            return to_qt(to_unicode(shown(of, row)));
        case typeset_role:  // words are running text
            if (std::holds_alternative<std::string>(of.cell(row))) return {};
            return QVariant::fromValue(shown(of, row));
        case exact_role: {
            const auto number = exact_number(of, row, view_.units);
            return number ? QVariant(*number) : QVariant();
        }
        case Qt::TextAlignmentRole:
            return QVariant((of.of_numbers ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return current_ ? extra(row, static_cast<std::size_t>(index.column()), role)
                            : QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
        case Qt::ToolTipRole:
            if (!current_) return tr("Out of date: the project has changed since.");
            [[fallthrough]];
        default:
            return extra(row, static_cast<std::size_t>(index.column()), role);
    }
}

QVariant ColumnTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical)
        return section < rowCount() ? row_title(static_cast<std::size_t>(section), role) : QVariant();
    if (section < 0 || section >= columnCount()) return {};
    const Column& of = column(section);
    if (role == Qt::DisplayRole) return to_qt(to_unicode(head(of)));
    if (role == typeset_role) return QVariant::fromValue(head(of));
    if (role == id_role) return to_qt(to_unicode(of.title));
    if (role == Qt::ToolTipRole) return to_qt(of.help);
    if (role == Qt::TextAlignmentRole)
        return QVariant((of.of_numbers ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}

Text ColumnTableModel::head(const Column& column) const {
    return head_written(core_title(column.title), column, view());
}

Text ColumnTableModel::shown(const Column& column, std::size_t row) const {
    return written(table_, column, row, view());
}

void ColumnTableModel::set_units(const DisplayUnits& units) {
    view_.units = units;
    tell();
}

void ColumnTableModel::set_digits(int digits) {
    view_.digits = digits;
    tell();
}

Table ColumnTableModel::file_table(const std::vector<int>& rows, const std::vector<int>& columns) const {
    Table shown{table_.id, table_.title, rows.size()};
    for (const int c : columns) {
        Column& added = shown.add(column(c));
        added.in_files = true;
        added.cell = Cells([cells = added.cell, rows](std::size_t row) {
            return cells(static_cast<std::size_t>(rows[row]));
        });
    }
    return shown;
}

void ColumnTableModel::set_contents(std::shared_ptr<const void> owner, Table table,
                                    std::vector<std::string> keys, bool current) {
    const bool same_shape = keys.size() == keys_.size() && table.rows == table_.rows;
    if (!same_shape) beginResetModel();
    owner_ = std::move(owner);
    table_ = std::move(table);
    keys_ = std::move(keys);
    current_ = current;
    if (!same_shape)
        endResetModel();
    else
        tell();
}

void ColumnTableModel::tell() {
    if (rowCount() == 0 || columnCount() == 0) return;
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

}  // namespace covaria::ui
