// Read-only tables.
#include "ui/models/column_table_model.h"

#include <QGuiApplication>
#include <QPalette>

#include "ui/models/roles.h"

namespace covaria::ui {

int ColumnTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_);
}

int ColumnTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant ColumnTableModel::extra(std::size_t, std::size_t, int) const {
    return {};
}

QString ColumnTableModel::row_title(std::size_t row) const {
    return QString::number(row + 1);
}

QVariant ColumnTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const auto row = static_cast<std::size_t>(index.row());
    const Column& column = columns_[static_cast<std::size_t>(index.column())];
    switch (role) {
        case Qt::DisplayRole:
            return column.text(row);
        case sort_role:
            return column.number ? QVariant(column.number(row)) : QVariant(column.text(row));
        case Qt::TextAlignmentRole:
            return QVariant((column.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
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
        return role == Qt::DisplayRole && section < rowCount()
                   ? QVariant(row_title(static_cast<std::size_t>(section)))
                   : QVariant();
    if (section < 0 || section >= columnCount()) return {};
    const Column& column = columns_[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) return column.title;
    if (role == id_role) return column.title.section(QStringLiteral(" / "), 0, 0);
    if (role == Qt::ToolTipRole) return column.help;
    if (role == Qt::TextAlignmentRole)
        return QVariant((column.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}

void ColumnTableModel::set_contents(std::vector<Column> columns, std::size_t rows, bool current) {
    const bool same_shape = columns.size() == columns_.size() && rows == rows_;
    if (!same_shape) beginResetModel();
    columns_ = std::move(columns);
    rows_ = rows;
    current_ = current;
    if (!same_shape) {
        endResetModel();
        return;
    }
    if (rows_ == 0 || columns_.empty()) return;
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

}  // namespace covaria::ui
