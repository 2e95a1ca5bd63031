// A table defined once: columns over SI values. The window, reports, CSV, results.json and the clipboard
// choose columns, units and a way to write numbers.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/data_table.h"
#include "core/base/message.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"

namespace covaria {

/// "mm/K": of a quantity in one unit per one in another, on scales of differences; none for equal units.
Unit quotient(const Unit& of, const Unit& per);

/// A number, SI, with the unit that it is given in.
struct Measured {
    enum class Scale { value, interval };  ///< an interval (difference, uncertainty) knows no zero of degC
    double si = 0.0;
    Scale scale = Scale::interval;
    Unit unit = {};
    Unit per = {};  ///< of the denominator: a sensitivity coefficient
    /// As a view with these units shows it; a quotient in the quotient of the units.
    Quantity in(const DisplayUnits& units) const;
};
/// Symbols as they are stored.
using Symbols = std::vector<std::string>;
struct Answer {
    bool is = false;
    std::string yes = "yes", no = "no";  ///< in files
    bool is_open = false;                ///< people read "undecided"
};
/// What a cell says. A unit is shown as the view's choice for it.
using Cell = std::variant<std::monostate, std::string, Message, Symbols, Text, Unit, Answer, Measured>;

/// How the numbers of a column are rounded for people.
struct NumberRule {
    int digits = 0;          ///< significant ones in print
    int decimals = -1;       ///< fixed instead
    std::string match = {};  ///< key of the column whose number (an uncertainty) decides the decimals
    /// Keys of columns, its own among them: those that the table has share one power of ten in a row, in one
    /// unit.
    std::vector<std::string> row = {};
    bool input = false;  ///< matched only where it was computed: a typed estimate keeps its digits
    bool typed = false;  ///< every digit that was typed
    bool degrees_of_freedom = false;
    bool percent = false;   ///< a part of one, shown in per cent
    bool no_fewer = false;  ///< than its own digits, whatever those of U are: it is no uncertainty
    bool of_limit = false;  ///< a part of a limit: what exceeds it is not written as 1
};

struct Column {
    std::string key;  ///< head in files; what views choose by
    std::function<Cell(std::size_t row)> cell;
    std::string head = {};   ///< in print; "%1" is the unit of all its numbers
    bool is_symbol = false;  ///< the head
    bool symbols = false;    ///< the cells
    Text title = {};         ///< head in the window
    Message help = {};       ///< for the window
    NumberRule rule = {};
    std::optional<Unit> unit = {};  ///< of all its numbers: the head says it
    bool says_unit = false;         ///< people read each number with its unit, which nothing else gives
    bool in_files = true;
    bool own_words = false;                    ///< its texts are the program's ("not met"), not people's
    std::vector<std::string> undeclared = {};  ///< those of them that no registry declares

    // To write columns down on a line.
    Column& print(std::string words) { return head = std::move(words), *this; }
    Column& print_symbol(std::string symbol) { return head = std::move(symbol), is_symbol = true, *this; }
    Column& window(Text words, std::string_view tip = {}) {
        return title = std::move(words), help = Message::declared(tip), *this;
    }
    Column& tip(Message words) { return help = std::move(words), *this; }
    Column& round(NumberRule by) { return rule = std::move(by), *this; }
    Column& no_fewer_digits() { return rule.no_fewer = true, *this; }
    Column& digits(int significant) { return rule.digits = significant, *this; }
    Column& match(std::string to) { return rule.match = std::move(to), *this; }
    Column& of_row(std::vector<std::string> keys) { return rule.row = std::move(keys), *this; }
    Column& in(std::optional<Unit> common) { return unit = std::move(common), *this; }
    Column& with_unit() { return says_unit = true, *this; }
    Column& of_symbols() { return symbols = true, *this; }
    Column& of_own_words(std::vector<std::string> others = {}) {
        return own_words = true, undeclared = std::move(others), *this;
    }
    Column& not_in_files() { return in_files = false, *this; }
};

/// Reads what it was made from when it is asked for cells: that must live.
struct Table {
    std::string id, title;
    std::size_t rows = 0;
    std::vector<Column> columns = {};

    Column& add(std::string key, std::function<Cell(std::size_t row)> cell) {
        return columns.emplace_back(Column{std::move(key), std::move(cell)});
    }
    const Column* find(std::string_view key) const;
    /// The column of that key, which there is.
    const Column& operator[](std::string_view key) const;
    Cell cell(std::size_t row, std::string_view key) const { return (*this)[key].cell(row); }
};

/// Full precision, in the units chosen: these columns, or those that files have.
DataTable data_table(const Table& table, const std::vector<std::string>& keys,
                     const DisplayUnits& units = {});
DataTable data_table(const Table& table);

/// What a view of a table depends on beside its columns.
struct TableView {
    DisplayUnits units = {};
    int digits = 0;  ///< significant digits of uncertainties; 0: those of the columns
    DocumentLanguage language = {};
};
/// Head with its unit: "|c|·u / mm".
Text head_shown(const Column& column, const TableView& view);
/// Likewise, under another title.
Text head_shown(const Text& title, const Column& column, const TableView& view);
/// Rounded, typeset; the program's words in the view's language.
Text cell_shown(const Table& table, const Column& column, std::size_t row, const TableView& view);
/// What else decides how a number is written.
struct NumberPlace {
    std::optional<double> other = {};    ///< the uncertainty that it is matched to
    std::optional<double> largest = {};  ///< in size, of its row
    NumberForm column = NumberForm::each;
};
/// By its rule, plain.
std::string format_by(const NumberRule& rule, double value, const NumberPlace& place = {});
/// A number as a view shows it; nothing for other cells.
std::optional<double> number_in(const Cell& cell, const DisplayUnits& units = {});
/// Likewise with all its digits, for programs: in the unit, or in per cent, that the head says.
std::optional<double> exact_number(const Column& column, std::size_t row, const DisplayUnits& units = {});
bool is_numeric(const Column& column);
/// Of a matched column: the number that decides the decimals of this cell.
std::optional<double> matched_to(const Table& table, const Column& column, std::size_t row,
                                 const DisplayUnits& units);

}  // namespace covaria
