// An Excel workbook while it is written: cells with texts, numbers and formulas with their values.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "core/base/error.h"

namespace covaria {

class XlsxBook {
public:
    enum class Look { plain, after_number, head, head_of_numbers, title, stated, good };

    XlsxBook();
    ~XlsxBook();
    XlsxBook(const XlsxBook&) = delete;
    XlsxBook& operator=(const XlsxBook&) = delete;

    /// Adds a sheet, whose name becomes one that Excel takes: 31 characters, none of []:*?/\, unique. Cells
    /// are written to the newest sheet.
    void add_sheet(const std::string& name);
    void set_width(int column, double characters);
    // Rows and columns count from 1.
    /// Keeps the rows down to `row` and the columns up to `column` in sight; each printed page repeats row
    /// `row`.
    void freeze_heads(int row, int column);
    /// Names a cell of the sheet for formulas in it; `name` is a word of letters and underscores.
    void name_cell(const std::string& name, int row, int column);
    /// Draws bars of the numbers of a column from `first` to `last`, labelled by the texts of another column,
    /// with their upper left corner in a cell.
    void bars(int row, int column, const std::string& title, int texts, int numbers, int first, int last);
    /// Writes a text, which is never computed and never a link, whatever it begins with.
    void text(int row, int column, const std::string& text, Look look = Look::plain);
    /// Writes a number with all its digits, shown in a format of Excel ("0.000"; empty: as Excel likes).
    /// Infinite and undefined ones are words.
    void number(int row, int column, double value, Look look = Look::plain, const std::string& format = {});
    void formula(int row, int column, const std::string& formula, double value, Look look = Look::plain,
                 const std::string& format = {});
    void text_formula(int row, int column, const std::string& formula, const std::string& value);
    /// The bytes of the file. Error{io}: it cannot be made in the folder for temporary files.
    Result<std::string> finish();

private:
    struct Sheets;
    std::unique_ptr<Sheets> sheets_;
    std::set<std::string> names_;
};

/// The name of a cell: "C5".
std::string cell_name(int row, int column);

}  // namespace covaria
