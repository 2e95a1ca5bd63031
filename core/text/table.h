// A table defined once: columns over SI values, each with the rule by which its numbers are rounded for
// people. The window, reports, CSV, results.json and the clipboard choose columns, units and digits; `cell.h`
// writes.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/message.h"
#include "core/text/display_units.h"
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
    Unit per = {};  ///< unit of the denominator: a sensitivity coefficient

    Measured() = default;
    /// A number alone is one of the unit one.
    Measured(double in_si, Scale of = Scale::interval, Unit in = {}, Unit per_unit = {})
        : si(in_si), scale(of), unit(std::move(in)), per(std::move(per_unit)) {}
    /// The number in a view with these units; a quotient in the quotient of the units.
    Quantity in(const DisplayUnits& units) const;
};
/// Symbols as they are stored.
using Symbols = std::vector<std::string>;
struct Answer {
    bool is = false;
    std::string yes = "yes", no = "no";  ///< words in files; people read "yes" and "no"
    bool is_open = false;                ///< people read "undecided"
};
/// A decision about the row that it stands in: a test, a limit with its probability.
struct TestVerdict {
    enum class Is { met, not_met, open };
    Is is = Is::open;  ///< open: the data do not decide
    Message words;     ///< those of the table: "conforms", "not passed"
};
/// Content of a cell. A unit, and a number with one, is shown in the view's choice for it. A `Quantity` is a
/// number as somebody typed it, of which no digit is lost.
using Cell = std::variant<std::monostate, std::string, Message, Symbols, Text, Unit, Answer, TestVerdict,
                          Quantity, Measured>;

/// Kind of the numbers of a column, which decides how they are rounded for people.
enum class NumberRole {
    typed,               ///< every digit that was typed; seven of what was computed
    uncertainty,         ///< significant digits: those of the view, no fewer than `digits`
    estimate,            ///< rounded to match the uncertainty in the column `of`
    figure,              ///< `digits` significant ones, whatever those of uncertainties are
    fixed,               ///< `decimals`
    part_of_limit,       ///< `decimals`; what exceeds the limit is not written as 1
    degrees_of_freedom,  ///< cut off, as k of the t distribution wants them
};

/// Rule by which the numbers of a column are rounded for people.
struct NumberRule {
    NumberRole role = NumberRole::typed;
    int digits = 0;
    int decimals = 0;
    std::string of = {};  ///< key of the column whose number (an uncertainty) decides the decimals
    /// Keys of columns, its own among them: those that the table has share one power of ten in a row, in one
    /// unit.
    std::vector<std::string> row = {};
    bool keeps_typed = false;  ///< an estimate that was typed keeps its digits; one that was computed matches
    bool percent = false;      ///< a part of one, shown in per cent
    bool no_fewer = false;     ///< a figure has no fewer digits than uncertainties in this view
    std::vector<int> by_row = {};  ///< decimals of each row instead, of series of readings; -1: none
    /// Form of a part of a table, with powers of ten or without; nothing: as the numbers shown want it.
    std::optional<NumberForm> form = {};
};

/// The cells of a column: a function of the row, or the cells themselves.
class Cells {
public:
    Cells() = default;
    Cells(std::function<Cell(std::size_t row)> of_row) : of_row_(std::move(of_row)) {}
    Cell operator()(std::size_t row) const {
        if (of_row_) return of_row_(row);
        return row < held_.size() ? held_[row] : Cell();
    }
    /// The cell of that row; rows before it that have none are empty.
    void hold(std::size_t row, Cell cell) {
        held_.resize(row);
        held_.push_back(std::move(cell));
    }
    Cells part(std::size_t begin, std::size_t end) const;

private:
    std::function<Cell(std::size_t row)> of_row_;
    std::vector<Cell> held_;
};

struct Column {
    std::string key;  ///< head in files; what views choose by; head for people where no other is given
    Cells cell = {};
    std::string head = {};   ///< head in print; "%1" is the unit of all its numbers
    bool is_symbol = false;  ///< the head, or the key ("u_cal") where that is the head
    bool symbols = false;    ///< the cells
    Text title = {};         ///< head in the window
    Message help = {};       ///< help in the window
    NumberRule rule = {};
    std::optional<Unit> unit = {};  ///< unit of all its numbers: the head says it
    bool of_numbers = false;        ///< set flush right in the window
    bool says_unit = false;         ///< people read each number with its unit, which nothing else gives
    bool in_files = true;
    bool hidden = false;                       ///< people do not see it
    bool own_words = false;                    ///< its texts are the program's ("not met"), not people's
    std::vector<std::string> undeclared = {};  ///< those of its texts that no registry declares

    // Setters, to write columns down on a line.
    Column& print(std::string words) { return head = std::move(words), *this; }
    Column& print_symbol(std::string symbol) { return head = std::move(symbol), is_symbol = true, *this; }
    Column& window(Text words, std::string_view tip = {}) {
        return title = std::move(words), help = Message::declared(tip), *this;
    }
    Column& tip(Message words) { return help = std::move(words), *this; }
    Column& round(NumberRule by) {
        by.row = std::move(rule.row);
        return rule = std::move(by), of_numbers = true, *this;
    }
    /// Numbers that are read against each other ask for no fewer digits than `at_least`.
    Column& uncertainty(int at_least = 0) {
        return round({.role = NumberRole::uncertainty, .digits = at_least});
    }
    Column& estimate_of(std::string key_of_u) {
        return round({.role = NumberRole::estimate, .of = std::move(key_of_u)});
    }
    /// An estimate that was typed keeps its digits.
    Column& input_of(std::string key_of_u) {
        return round({.role = NumberRole::estimate, .of = std::move(key_of_u), .keeps_typed = true});
    }
    Column& figure(int digits) { return round({.role = NumberRole::figure, .digits = digits}); }
    /// Figures with the digits of uncertainties where those are more.
    Column& figure_no_fewer(int digits) {
        return round({.role = NumberRole::figure, .digits = digits, .no_fewer = true});
    }
    Column& fixed(int decimals) { return round({.role = NumberRole::fixed, .decimals = decimals}); }
    Column& percent(int decimals) {
        return round({.role = NumberRole::fixed, .decimals = decimals, .percent = true});
    }
    Column& part_of_limit(int decimals) {
        return round({.role = NumberRole::part_of_limit, .decimals = decimals});
    }
    Column& degrees_of_freedom() { return round({.role = NumberRole::degrees_of_freedom}); }
    Column& typed() { return round({}); }
    Column& of_row(std::vector<std::string> keys) { return rule.row = std::move(keys), *this; }
    Column& in(std::optional<Unit> common) { return unit = std::move(common), *this; }
    Column& with_unit() { return says_unit = true, *this; }
    /// The key is a symbol.
    Column& symbol(bool is = true) { return is_symbol = is, *this; }
    Column& of_symbols() { return symbols = true, *this; }
    Column& of_own_words(std::vector<std::string> others = {}) {
        return own_words = true, undeclared = std::move(others), *this;
    }
    Column& hide() { return hidden = true, *this; }
    Column& not_in_files() { return in_files = false, *this; }
};

/// Used by models, assets, results, reports and the window alike. Columns by functions read what they were
/// made from when they are asked for cells: that must live.
struct Table {
    std::string id;  ///< file-name friendly ("budget-x-7")
    std::string title = {};
    std::size_t rows = 0;  ///< number of rows with those of sub-heads
    std::vector<Column> columns = {};
    std::vector<Message> notes = {};
    std::map<std::size_t, std::string> subheads = {};  ///< rows that have one text across the table

    Column& add(std::string key, std::function<Cell(std::size_t row)> cell) {
        return columns.emplace_back(Column{std::move(key), std::move(cell)});
    }
    /// A column of cells that rows bring.
    Column& add(std::string key) { return columns.emplace_back(Column{std::move(key)}); }
    Column& add(Column column) { return columns.emplace_back(std::move(column)); }
    /// A row by its cells, which may be fewer than columns. A number of the unit one is SI in the unit of a
    /// column that has one.
    void row(std::vector<Cell> cells);
    void subhead(std::string text) { subheads.emplace(rows++, std::move(text)); }
    bool is_subhead(std::size_t row) const { return subheads.contains(row); }

    const Column* find(std::string_view key) const;
    /// The column of that key, which there is.
    const Column& operator[](std::string_view key) const;
    Cell cell(std::size_t row, std::string_view key) const { return (*this)[key].cell(row); }
    /// Number of columns that views show; they stand before the hidden ones.
    std::size_t shown_columns() const;
    /// The rows from `begin` to before `end`.
    Table part(std::size_t begin, std::size_t end) const;
};

/// The table as files have it, its cells held: nothing is read later.
Table file_table(const Table& table);

/// Text of a cell in files: in English, units as in the view; empty for numbers.
std::string english_of(const Cell& cell, const DisplayUnits& units = {});
/// The number of a cell as files have it, with the unit: a typed one as it was typed.
std::optional<Quantity> exact_quantity(const Cell& cell, const DisplayUnits& units = {});

}  // namespace covaria
