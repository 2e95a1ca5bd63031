#include "ui/models/budget_sheet_model.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/text/head_with_unit.h"
#include "core/text/symbol.h"
#include "core/views/result_columns.h"
#include "ui/document/observation_edits.h"
#include "ui/document/quantity_text.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/number_words.h"
#include "ui/models/roles.h"
#include "ui/models/stated_part.h"
#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr std::size_t most_listed = 3;  // observations in a cell

struct SectionHead {
    const char* title;
    const char* help;
    const char* of_setup;   ///< key of the column that it shows; null: none
    const char* of_budget;  ///< key of the column of the result's budget; null: none
};

constexpr std::array<SectionHead, BudgetSheetModel::sections> heads{{
    {QT_TR_NOOP("symbol"), QT_TR_NOOP("As the equations use it; further rows of a symbol add components"),
     "symbol", nullptr},
    {QT_TR_NOOP("quantity"), QT_TR_NOOP("What it is"), "name", nullptr},
    {QT_TR_NOOP("estimate"), QT_TR_NOOP("In the row's unit: 50.000 838 or 50.000 838 mm"), "value", nullptr},
    {QT_TR_NOOP("unit"), QT_TR_NOOP("Of the estimate, and of what is stated without a unit"), "unit",
     nullptr},
    {QT_TR_NOOP("stated as"), "", "statement", nullptr},
    {QT_TR_NOOP("distr."), QT_TR_NOOP("Distribution that Monte Carlo draws"), nullptr, "distribution"},
    {QT_TR_NOOP("type"), QT_TR_NOOP("Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)"), nullptr, "type"},
    {"nu", QT_TR_NOOP("Degrees of freedom; empty: infinite, or those of the observations"), "nu",
     "degrees of freedom"},
    {"u", QT_TR_NOOP("Standard uncertainty, in the row's unit"), nullptr, "u"},
    {"c", QT_TR_NOOP("Sensitivity coefficient, unit of the result per unit of the row"), nullptr,
     "sensitivity"},
    {"|c|·u", QT_TR_NOOP("Contribution to the standard uncertainty of the result"), nullptr, "contribution"},
    {QT_TR_NOOP("share / %"), QT_TR_NOOP("Share of the variance, with its part of the covariances"), nullptr,
     "share of variance"},
    {QT_TR_NOOP("source"), QT_TR_NOOP("Where the figure comes from"), "source", nullptr},
}};

const SectionHead& head_of(int section) {
    return heads[static_cast<std::size_t>(section)];
}

/// 10.13, not 10.129999999999999.
double without_noise(double mean) {
    return QString::number(mean, 'g', 12).toDouble();
}

/// Kinds of statements whose figure is in proportion to u.
const std::set<std::string> by_their_figure{"standard-deviation", "certificate-k", "certificate-p",
                                            "rectangular",        "triangular",    "arcsine",
                                            "trapezoidal",        "resolution"};

}  // namespace

BudgetSheetModel::BudgetSheetModel(Document& document, const SetupAddress& address, const FieldSpec& field,
                                   QObject* parent)
    : SpreadsheetModel(parent),
      document_(document),
      address_(address),
      field_(field),
      sheet_(document, address, field.key),
      figures_([this](std::size_t row) { return unit_of(static_cast<int>(row)); }) {
    follow_sheet();
    follow_observations();
    connect(&document_, &Document::project_changed, this, &BudgetSheetModel::follow_observations);
}

bool BudgetSheetModel::is_computed(int section) {
    return head_of(section).of_setup == nullptr;
}

void BudgetSheetModel::follow_sheet() {
    connect(&sheet_, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex& first, const QModelIndex& last) {
                emit dataChanged(index(first.row(), 0), index(last.row(), sections - 1));
            });
    connect(&sheet_, &QAbstractItemModel::rowsAboutToBeInserted, this,
            [this](const QModelIndex&, int first, int last) {
                beginInsertRows({}, first, last);
                figures_.move(first, last - first + 1);
            });
    connect(&sheet_, &QAbstractItemModel::rowsInserted, this, [this] { endInsertRows(); });
    connect(&sheet_, &QAbstractItemModel::rowsAboutToBeRemoved, this,
            [this](const QModelIndex&, int first, int last) {
                beginRemoveRows({}, first, last);
                figures_.move(first, first - last - 1);
            });
    connect(&sheet_, &QAbstractItemModel::rowsRemoved, this, [this] { endRemoveRows(); });
    connect(&sheet_, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
    connect(&sheet_, &QAbstractItemModel::modelReset, this, [this] { endResetModel(); });
}

void BudgetSheetModel::set_result(std::shared_ptr<const UncertaintyResult> result, std::size_t output,
                                  bool current) {
    if (result && output >= result->budget.rows.size()) result.reset();
    // The rows of an earlier result may have moved since: they were followed.
    const bool is_followed = !current && result == result_ && output == output_;
    result_ = std::move(result);
    output_ = output;
    current_ = current;
    if (!is_followed) {
        figures_.follow(result_, output_, field_.key);
        largest_share_ = 0.0;
        for (int row = 0; row < sheet_.rowCount(); ++row)
            largest_share_ = std::max(largest_share_, share_of(static_cast<std::size_t>(row)));
    }
    emit headerDataChanged(Qt::Horizontal, 0, sections - 1);
    emit dataChanged(index(0, 0), index(rowCount() - 1, sections - 1));
}

void BudgetSheetModel::set_units(const DisplayUnits& units) {
    units_ = units;
    figures_.set_units(units);
    emit headerDataChanged(Qt::Horizontal, 0, sections - 1);
    emit dataChanged(index(0, 0), index(rowCount() - 1, sections - 1));
}

void BudgetSheetModel::follow_observations() {
    const FieldSpec* table = observing_table(document_.project(), address_);
    const Setup* setup = find_setup(document_.project(), address_);
    if (!table || !setup || value_of(*table, *setup) == observations_) return;
    observations_ = value_of(*table, *setup);
    observed_.clear();
    if (sheet_.rowCount() > 0) emit dataChanged(index(0, stated), index(sheet_.rowCount() - 1, stated));
}

std::string BudgetSheetModel::symbol_of(int row) const {
    if (row < 0 || is_new_row(row)) return {};
    return plain_symbol(to_std(sheet_.index(row, column_of(symbol)).data(Qt::EditRole).toString()));
}

std::string BudgetSheetModel::component_of(int row) const {
    const BudgetComponent* of = row < 0 ? nullptr : figures_.component(static_cast<std::size_t>(row));
    return of ? of->id : std::string();
}

int BudgetSheetModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : sheet_.rowCount() + (is_linked() ? 0 : 1);
}

int BudgetSheetModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : sections;
}

int BudgetSheetModel::column(const char* key) const {
    return static_cast<int>(SetupSchema::column(field_, key));
}

int BudgetSheetModel::column_of(int section) const {
    const char* key = head_of(section).of_setup;
    return key ? column(key) : -1;
}

std::optional<double> BudgetSheetModel::number_at(int row, const char* key) const {
    if (is_new_row(row)) return std::nullopt;
    const SetupCell& cell =
        sheet_.table().rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column(key))];
    const double* number = std::get_if<double>(&cell);
    return number ? std::optional(*number) : std::nullopt;
}

std::string BudgetSheetModel::text_at(int row, const char* key) const {
    if (is_new_row(row)) return {};
    const SetupCell& cell =
        sheet_.table().rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column(key))];
    const std::string* text = std::get_if<std::string>(&cell);
    return text ? *text : std::string();
}

Unit BudgetSheetModel::unit_of(int row) const {
    return Unit::parse(text_at(row, "unit")).value_or(Unit());
}

const std::vector<double>& BudgetSheetModel::observed(const std::string& of) const {
    const auto [known, is_new] = observed_.try_emplace(of);
    if (is_new) known->second = observations_of(document_.project(), address_, of);
    return known->second;
}

QString BudgetSheetModel::stated_words(int row, bool typeset) const {
    if (is_new_row(row)) return {};
    const std::string kind = text_at(row, "statement");
    if (kind.empty()) return {};
    TypedStatement statement{kind, number_at(row, "a"), number_at(row, "b"), std::nullopt,
                             text_at(row, "stated_unit")};
    if (is_listed(kind)) statement.observations = observed(symbol_of(row));
    // A long list would take the room of what follows from it; where it is edited it is whole.
    const std::size_t count = statement.observations.size();
    const int decimals = common_decimals(statement.observations);
    const bool is_long = typeset && count > most_listed;
    if (is_long)
        statement.observations.resize(most_listed - 1);
    else if (is_listed(kind) && kind != "observations")
        statement.weights = weights_of(document_.project(), address_, symbol_of(row));
    const auto number = [typeset, decimals](double value) {
        const std::string alike = decimals < 0 ? std::string() : format_decimals(value, decimals);
        if (typeset) return grouped_digits(alike.empty() ? format_typed(value) : alike, user_numbers());
        return alike.empty() ? to_std(number_text(value, QLocale()))
                             : with_decimal_sign(alike, {.decimal = to_std(QLocale().decimalPoint())});
    };
    const QString words = to_qt(statement_text(statement, unit_of(row), number, core_words));
    return is_long ? words + QStringLiteral(" … (%1)").arg(count) : words;
}

QVariant BudgetSheetModel::of_sheet(int row, int section, int role) const {
    const QModelIndex cell = sheet_.index(row, column_of(section));
    if (section == symbol && (role == typeset_role || role == Qt::DisplayRole)) {
        const Text text = symbol_text(to_std(cell.data(Qt::EditRole).toString()));
        return role == typeset_role ? QVariant::fromValue(text) : QVariant(to_qt(to_unicode(text)));
    }
    const bool is_of_result =
        (section == estimate || section == nu) && cell.data(Qt::EditRole).toString().isEmpty();
    if (is_of_result && (role == Qt::DisplayRole || (role == Qt::ForegroundRole && !current_)))
        return computed(row, section, role);
    if (section == stated) return stated_cell(row, role);
    return cell.data(role);
}

/// The words of a statement, a text that cannot be read as it was typed, and problems of all its figures.
QVariant BudgetSheetModel::stated_cell(int row, int role) const {
    const QModelIndex kind = sheet_.index(row, column("statement"));
    const bool refused = sheet_.is_refused(row, column("statement"));
    if (role == Qt::DisplayRole || role == Qt::EditRole)
        return refused ? kind.data(Qt::EditRole) : QVariant(stated_words(row, role == Qt::DisplayRole));
    if (role == exact_role) return refused ? QVariant() : QVariant(stated_words(row, false));
    if (role == choices_role) return {};
    for (const char* key : {"statement", "a", "b", "stated_unit"}) {
        const QModelIndex cell = sheet_.index(row, column(key));
        if (!cell.data(problem_role).toString().isEmpty()) return cell.data(role);
    }
    if (role == Qt::ToolTipRole && sheet_.taken_words(row, kind.column()).isEmpty())
        return below_stated_part(field_, sheet_.table().rows[static_cast<std::size_t>(row)],
                                 core_text(statement_examples()));
    return kind.data(role);
}

double BudgetSheetModel::share_of(std::size_t row) const {
    if (!figures_.component(row)) return 0.0;
    return std::abs(exact_number(figures_.table()[head_of(share).of_budget], row).value_or(0.0));
}

QVariant BudgetSheetModel::computed(int row, int section, int role) const {
    const auto at = static_cast<std::size_t>(row);
    if (role == Qt::ForegroundRole && !current_)
        return QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
    if (role == Qt::TextAlignmentRole)
        return QVariant((section == distribution || section == type ? Qt::AlignLeft : Qt::AlignRight) |
                        Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && !current_) return tr("Out of date: being computed.");
    if (role == Qt::ToolTipRole && !sheet_.taken_words(row, column("statement")).isEmpty())
        return sheet_.taken_words(row, column("statement"));
    if (!figures_.component(at)) return {};
    if (role == shape_role)
        return section == distribution ? QVariant(to_qt(figures_.component(at)->distribution)) : QVariant();
    if (role == fraction_role)
        return section == share && largest_share_ > 0.0 ? QVariant(share_of(at) / largest_share_)
                                                        : QVariant();
    if (role == Qt::ToolTipRole && section == distribution) return computed(row, section, Qt::DisplayRole);
    if (section == estimate && row > 0 && symbol_of(row) == symbol_of(row - 1)) return {};  // it stands above
    const char* key = section == estimate ? "estimate" : head_of(section).of_budget;
    if (!key) return {};
    // Stated figures stay in the row's unit; contributions are in the unit of the results below.
    const TableView view{section == contribution ? figures_.units_of_contributions() : DisplayUnits(),
                         digits_, language_of_window()};
    const Column& of = figures_.table()[key];
    if (role == exact_role) {
        const auto number = exact_number(of, at, view.units);
        return number ? QVariant(*number) : QVariant();
    }
    if (role == Qt::DisplayRole) return to_qt(to_unicode(written(figures_.table(), of, at, view)));
    return role == typeset_role ? QVariant::fromValue(written(figures_.table(), of, at, view)) : QVariant();
}

QVariant BudgetSheetModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int section = index.column();
    if (role == help_role && (is_computed(section) || is_new_row(index.row())))
        return QStringLiteral("glossary-uncertainty-budget");
    if (is_computed(section)) return computed(index.row(), section, role);
    if (!is_new_row(index.row())) return of_sheet(index.row(), section, role);
    if (role == Qt::ToolTipRole && section == symbol) return tr("Type a name here to add a quantity");
    if (role == hint_role && section == name) return tr("type or paste rows");
    if (role == Qt::TextAlignmentRole)
        return QVariant((section == estimate || section == nu ? Qt::AlignRight : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    return {};
}

QVariant BudgetSheetModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        if (section >= sheet_.rowCount())
            return role == Qt::DisplayRole ? QVariant(QStringLiteral("+")) : QVariant();
        return sheet_.headerData(section, orientation, role);
    }
    if (section < 0 || section >= sections) return {};
    const SectionHead& head = head_of(section);
    Text title = section == nu ? symbol_text("nu") : Text(to_std(ui::tr(head.title)));
    const bool of_output = section == c || section == contribution || section == share;
    if (of_output && result_ && result_->outputs.size() > 1)
        title = title + " (" + symbol_text(result_->outputs[output_].quantity.symbol) + ")";
    if (section == contribution && result_)
        title = head_with_unit(
            title, figures_.units_of_contributions().of(result_->outputs[output_].quantity.unit).interval());
    if (role == Qt::DisplayRole) return to_qt(to_unicode(title));
    if (role == typeset_role) return QVariant::fromValue(title);
    if (role == Qt::ToolTipRole)
        return section == stated ? core_text(statement_examples()) : ui::tr(head.help);
    return {};
}

Qt::ItemFlags BudgetSheetModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = SpreadsheetModel::flags(index);
    const bool editable = index.isValid() && !is_linked() &&
                          (!is_computed(index.column()) || (index.column() == u && !is_new_row(index.row())));
    return editable ? flags | Qt::ItemIsEditable : flags;
}

/// "10.1; 10.3; 10.2 mm" gives a row its unit that has neither one nor an estimate.
std::optional<Unit> BudgetSheetModel::unit_of_list(int row, const QString& text) const {
    if (!text_at(row, "unit").empty() || number_at(row, "value")) return std::nullopt;
    const auto last = parse_unit(text.trimmed().section(QLatin1Char(' '), -1));
    if (!last || *last == Unit()) return std::nullopt;
    const auto read = read_in(text, *last);
    return read && !read->observations.empty() ? std::optional(*last) : std::nullopt;
}

Result<TypedStatement> BudgetSheetModel::read_in(const QString& text, const Unit& of_row) const {
    return read_statement(to_std(text), of_row, QLocale().decimalPoint() == QLatin1String(","), core_words);
}

Result<TypedStatement> BudgetSheetModel::read_typed(int row, const QString& text) const {
    return read_in(text, unit_of_list(row, text).value_or(unit_of(row)));
}

void BudgetSheetModel::take_observations(int row, const QString& text, const QString& step) {
    const auto read = read_typed(row, text);
    const FieldSpec* table = observing_table(document_.project(), address_);
    if (!read || read->observations.empty() || !table || symbol_of(row).empty()) return;
    if (!file_of_observations(document_.project(), address_).empty()) return;
    document_.apply(
        SetupTableModel::tr("Change %1: %2").arg(core_text(table->title), to_qt(symbol_of(row))),
        [&](Project& project) {
            set_observations(project, address_, symbol_of(row), read->observations, read->weights);
        },
        step);
}

int BudgetSheetModel::write(int row, int section, const QString& text, const QString& step) {
    if (section == stated) take_observations(row, text, step);
    if (const auto concise = section == estimate ? concise_parts(text) : std::nullopt;
        concise && sheet_.cells_of_value(row, concise->value)[column("value")].refused.isEmpty())
        return write(row, estimate, concise->value, step) + write(row, stated, concise->uncertainty, step);
    return sheet_.write_row(row, cells_for(row, section, text), step, ui::tr(head_of(section).title));
}

BudgetSheetModel::Cells BudgetSheetModel::cells_of_statement(int row, const QString& text) const {
    const auto read = read_typed(row, text);
    Cells cells;
    const auto refuse = [&](const QString& why) {
        cells[column("statement")] = {text, why};
        return cells;
    };
    if (!read) return refuse(to_qt(read.error().message));
    if (const auto of_list = unit_of_list(row, text)) cells[column("unit")] = {to_qt(of_list->text())};
    if (!read->observations.empty()) {
        if (symbol_of(row).empty()) return refuse(tr("Name the quantity before its observations."));
        const std::string file = file_of_observations(document_.project(), address_);
        if (!file.empty()) return refuse(tr("The observations are read from %1.").arg(to_qt(file)));
        cells[column("value")] = {};  // their mean
    } else if (is_listed(text_at(row, "statement")) && !is_listed(read->kind) && !number_at(row, "value")) {
        if (const auto mean = listed_mean(document_.project(), address_, symbol_of(row)))
            cells[column("value")] = {.number = *mean};
    }
    cells[column("statement")] = {to_qt(read->kind)};
    cells[column("a")] = {.number = read->a};
    cells[column("b")] = {.number = read->b};
    cells[column("stated_unit")] = {to_qt(read->unit)};
    // Degrees of freedom of another kind of statement, or of another certificate, are not its own.
    const std::string before = text_at(row, "statement");
    const bool is_another =
        !before.empty() &&
        (read->kind != before || (read->kind.starts_with("certificate") && read->b != number_at(row, "b")));
    if (read->degrees_of_freedom || is_another) cells[column("nu")] = {.number = read->degrees_of_freedom};
    return cells;
}

BudgetSheetModel::Cells BudgetSheetModel::cells_for(int row, int section, const QString& text) const {
    if (section == stated) return cells_of_statement(row, text);
    if (section == estimate) return sheet_.cells_of_value(row, text);
    Cells cells;
    cells[column_of(section)] = {text};
    const QString figure = text.trimmed();  // "2 ppm" would be 0.000 002 degrees of freedom
    if (section == nu && figure == QStringLiteral("∞"))
        cells[column_of(section)] = {};  // no number of degrees of freedom is stated
    else if (section == nu && !figure.isEmpty() && !parse_number(figure, QLocale()))
        cells[column_of(section)] = {text, tr("“%1” is not a number of degrees of freedom.").arg(figure)};
    return cells;
}

bool BudgetSheetModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
    const QString text = value.toString();
    if (is_new_row(index.row()) && text.trimmed().isEmpty()) return false;
    if (index.column() == u) return state_u(index.row(), text);
    const bool bare = text.trimmed().isEmpty() || parse_number(without_groups(text.trimmed()), QLocale());
    typed_with_unit_ = index.column() == estimate && !bare ? index.row() : -1;
    write(index.row(), index.column(), text, next_step());
    if (index.column() == unit) read_again(index.row());
    return true;
}

/// The statement keeps its form, with figures by which u is what was typed; where it has none that can be
/// scaled, u is the statement.
bool BudgetSheetModel::state_u(int row, const QString& text) {
    if (text.trimmed().isEmpty()) return false;
    const auto read = read_typed(row, text);
    const BudgetComponent* of = figures_.component(static_cast<std::size_t>(row));
    const std::optional<double> a = number_at(row, "a");
    const bool scales = read && read->kind == "standard" && a && current_ && of &&
                        by_their_figure.contains(text_at(row, "statement"));
    const Unit of_row = unit_of(row).interval();
    const Unit typed =
        scales && !read->unit.empty() ? Unit::parse(read->unit).value_or(of_row).interval() : of_row;
    const double now = scales ? of->standard_uncertainty : 0.0;
    const double wanted = scales ? typed.interval_to_si(*read->a) : 0.0;
    if (!(now > 0.0) || !(wanted > 0.0) || typed.dimension() != of_row.dimension()) {
        write(row, stated, text, next_step());
        return true;
    }
    sheet_.write_row(row, {{column("a"), {.number = without_noise(*a * wanted / now)}}}, next_step());
    return true;
}

/// Reads the texts of a row again that were refused, now in another unit of the row.
void BudgetSheetModel::read_again(int row) {
    for (const auto& [section, key] :
         {std::pair(int(estimate), "value"), std::pair(int(stated), "statement")})
        if (sheet_.is_refused(row, column(key)))
            setData(index(row, section), sheet_.index(row, column(key)).data(Qt::EditRole));
}

bool BudgetSheetModel::insertRows(int row, int count, const QModelIndex& parent) {
    return sheet_.insertRows(std::min(row, sheet_.rowCount()), count, parent);
}

bool BudgetSheetModel::removeRows(int row, int count, const QModelIndex& parent) {
    return sheet_.removeRows(row, std::min(count, sheet_.rowCount() - row), parent);
}

void BudgetSheetModel::remove_rows_at(const std::set<int>& rows) {
    std::set<int> there = rows;
    there.erase(sheet_.rowCount());
    sheet_.remove_rows_at(there);
}

/// Passes over computed columns, so that a whole copied budget can be pasted back.
int BudgetSheetModel::paste(const QModelIndex& at, const QString& text) {
    const std::vector<QStringList> block = parse_block(text, QLocale());
    const int top = at.isValid() ? at.row() : sheet_.rowCount(), left = at.isValid() ? at.column() : 0;
    const QString step = next_step();
    int refused = 0;
    for (std::size_t r = 0; r < block.size() && !is_linked(); ++r) {
        const int row = top + static_cast<int>(r);
        const auto take = [&](int section) {
            const int given = section - left;
            if (given >= 0 && given < block[r].size() && !is_computed(section))
                refused += write(row, section, block[r][given], step);
        };
        take(unit);  // first: figures are read in it
        for (int section = left; section < sections; ++section)
            if (section != unit) take(section);
    }
    return refused;
}

/// Whether the cell belongs to the set-up's table: neither computed nor of the row for new ones.
bool BudgetSheetModel::is_typed(const QModelIndex& cell) const {
    return (flags(cell) & Qt::ItemIsEditable) && !is_computed(cell.column()) && !is_new_row(cell.row());
}

void BudgetSheetModel::fill_down(const QModelIndexList& cells) {
    std::map<int, std::set<int>> rows_of;
    for (const QModelIndex& cell : cells)
        if (is_typed(cell)) rows_of[cell.column()].insert(cell.row());
    const QString step = next_step();
    for (const auto& [section, rows] : rows_of)
        for (const int row : rows)
            if (row != *rows.begin())
                write(row, section, index(*rows.begin(), section).data(Qt::EditRole).toString(), step);
}

void BudgetSheetModel::clear(const QModelIndexList& cells) {
    const QString step = next_step();
    for (const QModelIndex& cell : cells)
        if (is_typed(cell)) write(cell.row(), cell.column(), QString(), step);
}

QString BudgetSheetModel::next_step() {
    return QStringLiteral("budget:%1").arg(++steps_);
}

}  // namespace covaria::ui
