// Showing and editing of cells; how the model follows the document is in setup_table_sync.cpp.
#include "ui/models/setup_table_model.h"

#include <QColor>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/temperature.h"
#include "core/setup/text_columns.h"
#include "core/text/head_with_unit.h"
#include "core/text/symbol.h"
#include "ui/document/project_edits.h"
#include "ui/document/quantity_text.h"
#include "ui/document/setup_cells.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/number_words.h"
#include "ui/models/roles.h"
#include "ui/models/stated_part.h"
#include "ui/theme/core_text.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {

bool is_numeric(const ColumnSpec& column) {
    return column.kind == FieldKind::number || column.kind == FieldKind::integer;
}

SetupCell& cell_at(SetupTable& table, int row, int column) {
    return table.rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
}

std::vector<SetupCell> new_row(const FieldSpec& field) {
    std::vector<SetupCell> row;
    for (const ColumnSpec& column : field.columns) row.push_back(empty_cell(column));
    return row;
}

}  // namespace

SetupTableModel::SetupTableModel(Document& document, SetupAddress address, std::string field, QObject* parent)
    : SetupTableModel(document, address, find_schema(document.project(), address), std::move(field), parent) {
}

SetupTableModel::SetupTableModel(Document& document, SetupAddress address, const SetupSchema* schema,
                                 std::string field, QObject* parent)
    : SpreadsheetModel(parent),
      document_(document),
      address_(std::move(address)),
      field_(std::move(field)),
      schema_(schema),
      table_(read()),
      decimals_(decimals_of_table()) {
    recall_rejected();
    refresh_problems();
    refresh_taken();
    connect(&document_, &Document::project_changed, this, &SetupTableModel::refresh);
    connect(&document_.maker(), &ProjectMaker::made_changed, this, &SetupTableModel::refresh_taken);
    connect(&document_, &Document::problems_changed, this, &SetupTableModel::refresh_problems);
    connect(&document_.unread(), &UnreadTexts::changed, this, &SetupTableModel::recall_rejected);
}

const FieldSpec* SetupTableModel::field() const {
    return schema_ ? schema_->find(field_) : nullptr;
}

const ColumnSpec& SetupTableModel::column(int index) const {
    return field()->columns[static_cast<std::size_t>(index)];
}

int SetupTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(table_.rows.size());
}

int SetupTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || !field() ? 0 : static_cast<int>(field()->columns.size());
}

QString SetupTableModel::complaint(const CellPosition& at) const {
    if (const auto found = rejected_.find(at); found != rejected_.end()) return found->second.reason;
    if (const auto found = problems_.find(at); found != problems_.end()) return found->second;
    // The first cell of a row shows the problem of the row as a whole.
    if (const auto found = problems_.find({at.first, -1}); at.second == 0 && found != problems_.end())
        return found->second;
    return {};
}

/// Columns that say which quantity a row states stay in use, and its unit with them.
QString SetupTableModel::taken_words(int row, int column_index) const {
    const auto found = taken_.find(row);
    if (found == taken_.end()) return {};
    const ColumnSpec& spec = column(column_index);
    const bool replaced = field()->states_quantities
                              ? !names_quantities(spec) && spec.key != "name" && spec.key != "unit"
                              : is_numeric(spec);
    return replaced ? found->second : QString();
}

QString SetupTableModel::tooltip(const CellPosition& at) const {
    if (const QString wrong = complaint(at); !wrong.isEmpty()) return wrong;
    if (const QString taken = taken_words(at.first, at.second); !taken.isEmpty()) return taken;
    static const std::set<std::string> about_figures{"statement", "a", "stated_unit"};
    const QString help = core_text(column(at.second).help);
    if (!field()->states_quantities || !about_figures.contains(column(at.second).key)) return help;
    return below_stated_part(*field(), table_.rows[static_cast<std::size_t>(at.first)], help);
}

std::string SetupTableModel::written_out(const CellPosition& at, double number) const {
    const auto row = static_cast<std::size_t>(at.first), column = static_cast<std::size_t>(at.second);
    const bool observed = column < decimals_.size() && row < decimals_[column].size();
    if (observed && decimals_[column][row] >= 0) return format_decimals(number, decimals_[column][row]);
    std::string typed = format_shortest(number);
    return typed.find('e') != std::string::npos ? format_typed(number) : typed;
}

QVariant SetupTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const CellPosition at{index.row(), index.column()};
    const ColumnSpec spec = choosable(column(at.second));
    const SetupCell& cell =
        table_.rows[static_cast<std::size_t>(at.first)][static_cast<std::size_t>(at.second)];
    const auto rejected = rejected_.find(at);
    switch (role) {
        case Qt::DisplayRole:
            if (const double* number = std::get_if<double>(&cell); number && rejected == rejected_.end())
                return to_qt(grouped_digits(written_out(at, *number), user_numbers()));
            if (const auto* text = std::get_if<std::string>(&cell);
                text && names_unit(spec.key) && rejected == rejected_.end())
                return to_qt(shown_text(spec.key, *text));
            [[fallthrough]];
        case Qt::EditRole:
            return rejected != rejected_.end() ? rejected->second.text : cell_text(spec, cell, QLocale());
        case exact_role:  // spreadsheets read no "5×10⁻⁷"
            if (const double* number = std::get_if<double>(&cell); number && rejected == rejected_.end())
                return *number;
            return {};
        case typeset_role:  // "theta" is a name in every other column
            if (const auto* name = std::get_if<std::string>(&cell);
                name && names_quantities(spec) && rejected == rejected_.end())
                return QVariant::fromValue(symbol_text(*name));
            return {};
        case Qt::TextAlignmentRole:
            return QVariant(is_numeric(spec) ? Qt::AlignRight | Qt::AlignVCenter
                                             : Qt::AlignLeft | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return tooltip(at);
        case Qt::ForegroundRole:  // still typed into: without the link it counts, and must be there
            return taken_words(at.first, at.second).isEmpty()
                       ? QVariant()
                       : QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
        case Qt::BackgroundRole:
            return complaint(at).isEmpty() ? QVariant() : QVariant(refused_ground());
        case problem_role:
            return complaint(at);
        case path_role:
            return to_qt(setup_path(document_.project(), address_) + '/' + field_ + "/rows/" +
                         std::to_string(at.first) + '/' + std::to_string(at.second));
        case help_role:
            return help_anchor(document_.project(), address_, field_, spec.key);
        case choices_role: {
            QStringList titles = choice_words(spec);
            if (spec.kind == FieldKind::flag)
                titles << cell_text(spec, true, {}) << cell_text(spec, false, {});
            return titles;
        }
        default:
            return {};
    }
}

QVariant SetupTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        if (role == Qt::DisplayRole) return section + 1;
        return role == Qt::ToolTipRole ? QVariant(complaint({section, -1})) : QVariant();
    }
    if (section < 0 || section >= columnCount()) return {};
    const Text title = head_with_unit(title_text(core_words(column(section).title)), unit(section));
    if (role == Qt::DisplayRole) return to_qt(to_unicode(title));
    if (role == typeset_role) return QVariant::fromValue(title);
    if (role == Qt::ToolTipRole) return core_text(column(section).help);
    return {};
}

Qt::ItemFlags SetupTableModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return index.isValid() && !is_linked() ? flags | Qt::ItemIsEditable : flags;
}

ColumnSpec SetupTableModel::choosable(ColumnSpec column) const {
    if (column.kind != FieldKind::reference) return column;
    column.kind = FieldKind::choice;
    column.choices = fitting_assets(document_.project(), column.capabilities, address_);
    return column;
}

bool SetupTableModel::write(const QString& text, const std::function<void(SetupTable&)>& change,
                            const QString& merge_key) {
    if (!field() || is_linked()) return false;
    const auto edit = [&](Project& project) {
        Setup* setup = find_setup(project, address_);
        if (!setup) return;
        SetupTable table = table_of(*field(), *setup);
        const SetupTable before = table;
        change(table);
        if (!(table == before)) setup->values[field_] = std::move(table);
    };
    return document_.apply(text, edit, merge_key);
}

void SetupTableModel::set_cell(SetupTable& table, const CellPosition& at, const QString& text,
                               Marks& marks) const {
    Result<SetupCell> cell = parse_cell(choosable(column(at.second)), unit(at.second), text, QLocale());
    marks[at] = cell ? Rejected{} : Rejected{text, to_qt(cell.error().message)};
    if (cell) cell_at(table, at.first, at.second) = std::move(*cell);
}

int SetupTableModel::take(const Marks& marks) {
    int refused = 0;
    for (const auto& [at, mark] : marks) {
        rejected_.erase(at);
        if (!mark.reason.isEmpty()) {
            rejected_[at] = mark;
            rejected_[at].instead_of = written(at);
            ++refused;
        }
        const QModelIndex cell = index(at.first, at.second);
        emit dataChanged(cell, cell);
    }
    remember_rejected();
    return refused;
}

std::map<int, SetupTableModel::TypedCell> SetupTableModel::cells_of_value(int row,
                                                                          const QString& text) const {
    const auto at = [this](const char* key) { return static_cast<int>(SetupSchema::column(*field(), key)); };
    const QString trimmed = without_groups(text.trimmed());
    qsizetype digits = trimmed.size();
    while (digits > 0 && !parse_number(trimmed.left(digits), QLocale())) --digits;
    const QString behind = trimmed.mid(digits).trimmed();
    // "1e400" is too large, no "1e40" in the unit "0"; "2e-6 1/K" is a number and its unit.
    const bool is_cut =
        digits > 0 && digits < trimmed.size() && trimmed[digits - 1].isDigit() && trimmed[digits].isDigit();
    if (digits == 0 || behind.isEmpty() || is_cut) return {{at("value"), {text}}};
    const auto typed = parse_unit(behind);
    if (!typed) return {{at("value"), {text, to_qt(typed.error().message)}}};
    const double value = *parse_number(trimmed.left(digits), QLocale());
    const QString written =
        row < rowCount() ? index(row, at("unit")).data(Qt::EditRole).toString() : QString();
    if (written.isEmpty()) return {{at("value"), {.number = value}}, {at("unit"), {to_qt(typed->text())}}};
    const Unit of_row = Unit::parse(to_std(written)).value_or(Unit());
    if (const Message objection = reading_objection(*typed, of_row); !objection.empty())
        return {{at("value"), {text, to_qt(objection)}}};
    if (typed->dimension() == of_row.dimension())
        return {{at("value"), {.text = text, .number = converted(value, *typed, of_row)}}};
    return {{at("value"),
             {text, tr("%1 is no unit for a quantity in %2.").arg(behind, to_qt(of_row.display()))}}};
}

bool SetupTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid) || is_linked())
        return false;
    if (field()->states_quantities && column(index.column()).key == "value") {
        write_row(index.row(), cells_of_value(index.row(), value.toString()));
        return true;
    }
    Marks marks;
    const QString at =
        name_of_row(index.row()) + QStringLiteral(", ") + core_text(column(index.column()).title);
    write(tr("Change %1: %2").arg(core_text(field()->title), at), [&](SetupTable& table) {
        set_cell(table, {index.row(), index.column()}, value.toString(), marks);
    });
    take(marks);
    return true;
}

/// Name of a row in the list of steps.
QString SetupTableModel::name_of_row(int row) const {
    const QString name = row < rowCount() ? index(row, 0).data(Qt::EditRole).toString().trimmed() : QString();
    return name.isEmpty() ? tr("row %1").arg(row + 1) : name;
}

bool SetupTableModel::insertRows(int row, int count, const QModelIndex& parent) {
    if (parent.isValid() || row < 0 || row > rowCount() || count < 1) return false;
    return write(tr("Insert rows in %1").arg(core_text(field()->title)), [&](SetupTable& table) {
        table.rows.insert(table.rows.begin() + row, static_cast<std::size_t>(count), new_row(*field()));
    });
}

bool SetupTableModel::removeRows(int row, int count, const QModelIndex& parent) {
    if (parent.isValid() || row < 0 || count < 1 || row + count > rowCount()) return false;
    return write(tr("Delete rows of %1").arg(core_text(field()->title)), [&](SetupTable& table) {
        table.rows.erase(table.rows.begin() + row, table.rows.begin() + row + count);
    });
}

int SetupTableModel::paste(const QModelIndex& at, const QString& text) {
    const std::vector<QStringList> block = parse_block(text, QLocale());
    if (block.empty() || is_linked()) return 0;
    const int top = at.isValid() ? at.row() : rowCount();
    const int left = at.isValid() ? at.column() : 0;
    Marks marks;
    write(tr("Paste into %1").arg(core_text(field()->title)), [&](SetupTable& table) {
        const std::size_t rows = std::max(table.rows.size(), static_cast<std::size_t>(top) + block.size());
        table.rows.resize(rows, new_row(*field()));
        for (std::size_t r = 0; r < block.size(); ++r) {
            const int columns = std::min(columnCount() - left, static_cast<int>(block[r].size()));
            for (int c = 0; c < columns; ++c)
                set_cell(table, {top + static_cast<int>(r), left + c}, block[r][c], marks);
        }
    });
    return take(marks);
}

int SetupTableModel::write_row(int row, const std::map<int, TypedCell>& cells, const QString& merge_key,
                               const QString& what) {
    if (is_linked()) return 0;
    Marks marks;
    const auto change = [&](SetupTable& table) {
        const std::size_t rows = std::max(table.rows.size(), static_cast<std::size_t>(row) + 1);
        table.rows.resize(rows, new_row(*field()));
        for (const auto& [column, typed] : cells) {
            const bool is_number = typed.number && std::isfinite(*typed.number);
            if (is_number) cell_at(table, row, column) = *typed.number;
            if (is_number || !typed.refused.isEmpty())
                marks[{row, column}] = {typed.text, typed.refused};
            else
                set_cell(table, {row, column}, typed.text, marks);
        }
    };
    const QString at = what.isEmpty() ? name_of_row(row) : name_of_row(row) + QStringLiteral(", ") + what;
    write(tr("Change %1: %2").arg(core_text(field()->title), at), change, merge_key);
    return take(marks);
}

void SetupTableModel::remove_rows_at(const std::set<int>& rows) {
    if (rows.empty()) return;
    if (static_cast<int>(rows.size()) == *rows.rbegin() - *rows.begin() + 1) {
        removeRows(*rows.begin(), static_cast<int>(rows.size()));
        return;
    }
    SetupTable table = table_;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) table.rows.erase(table.rows.begin() + *row);
    replace_table(table, tr("Delete rows"));
}

void SetupTableModel::fill_down(const QModelIndexList& cells) {
    std::map<int, std::set<int>> rows_of_column;
    for (const QModelIndex& cell : cells) rows_of_column[cell.column()].insert(cell.row());
    Marks marks;
    write(tr("Fill down in %1").arg(core_text(field()->title)), [&](SetupTable& table) {
        for (const auto& [column_index, rows] : rows_of_column)
            for (const int row : rows) {
                if (row != *rows.begin()) marks[{row, column_index}] = {};
                cell_at(table, row, column_index) = cell_at(table, *rows.begin(), column_index);
            }
    });
    take(marks);
}

void SetupTableModel::clear(const QModelIndexList& cells) {
    Marks marks;
    write(tr("Clear cells of %1").arg(core_text(field()->title)), [&](SetupTable& table) {
        for (const QModelIndex& cell : cells) {
            marks[{cell.row(), cell.column()}] = {};
            cell_at(table, cell.row(), cell.column()) = empty_cell(column(cell.column()));
        }
    });
    take(marks);
}

}  // namespace covaria::ui
