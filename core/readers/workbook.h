// Excel workbooks (.xlsx): the cells of their sheets as they were last computed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace covaria {

struct WorkbookCell {
    std::string text = {};              ///< text as stored: words, or the digits of a number
    std::optional<double> number = {};  ///< the number, where the text is one
    std::string failure = {};           ///< why it has no value: an error of Excel, a formula never computed
};

struct WorkbookSheet {
    std::string name;
    /// Cells with content, by row and column from 1.
    std::map<int, std::map<int, WorkbookCell>> rows = {};

    const WorkbookCell* cell(int row, int column) const;
    int first_column() const;  ///< first column that has a cell
    /// Sets a cell as if its text had been typed into the sheet; an empty text takes the cell away.
    void set_cell(int row, int column, const std::string& text);
    /// The place in words: "Budget!C5".
    std::string place(int row, int column) const;
    /// An error at a cell; its line is the row.
    tl::unexpected<Error> refused(int row, int column, const Message& message) const;
};

struct CellPlace {
    int row = 0, column = 0;  ///< numbers from 1
};
/// The place of a reference such as "C5"; empty where the text is none.
std::optional<CellPlace> place_of_cell(std::string_view reference);
/// The letters of a column: "C" for 3.
std::string column_letters(int column);

/// All sheets with cells, in the order of the workbook; hidden ones too. Formulas are never computed. Error:
/// no workbook, encrypted, damaged, an XML entity, more cells or bytes than a budget has.
Result<std::vector<WorkbookSheet>> read_workbook(const std::string& bytes);

}  // namespace covaria
