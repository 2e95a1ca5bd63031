// An Excel workbook while it is written: cells with texts, numbers and formulas with their values.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "core/base/error.h"

namespace covaria {

class XlsxBook {
public:
    enum class Look { plain, head, title, stated, good };

    XlsxBook();
    ~XlsxBook();
    XlsxBook(const XlsxBook&) = delete;
    XlsxBook& operator=(const XlsxBook&) = delete;

    /// A name as Excel takes it: 31 characters, none of []:*?/\, unique. Cells are written to the newest
    /// sheet.
    void add_sheet(const std::string& name);
    void set_width(int column, double characters);
    // Rows and columns from 1.
    /// Always a text, which is never computed and never a link, whatever it begins with.
    void text(int row, int column, const std::string& text, Look look = Look::plain);
    /// Infinite and undefined numbers are words.
    void number(int row, int column, double value, Look look = Look::plain);
    void formula(int row, int column, const std::string& formula, double value, Look look = Look::plain);
    void text_formula(int row, int column, const std::string& formula, const std::string& value);
    /// The file. Error{io}: it cannot be made in the folder for temporary files.
    Result<std::string> finish();

private:
    struct Sheets;
    std::unique_ptr<Sheets> sheets_;
    std::set<std::string> names_;
};

/// "C5"
std::string cell_name(int row, int column);

}  // namespace covaria
