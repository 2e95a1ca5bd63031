// Workbooks of one sheet, made of the texts of their cells.
#pragma once

#include <string>
#include <vector>

#include "core/setup/message_text.h"
#include "tests/core/readers/zipped.h"

namespace covaria::readers_test {

/// Cells as they stand in XML: `<v>1</v>`, or words; an empty one is none.
inline Parts workbook(const std::vector<std::vector<std::string>>& rows) {
    std::string sheet = "<worksheet><sheetData>";
    for (const auto& row : rows) {
        sheet += "<row>";
        for (const std::string& cell : row)
            sheet += cell.starts_with("<") ? "<c>" + cell + "</c>"
                                           : "<c t='inlineStr'><is><t>" + cell + "</t></is></c>";
        sheet += "</row>";
    }
    return {{"xl/workbook.xml",
             "<workbook xmlns:r='x'><sheets><sheet name='B' sheetId='1' r:id='r1'/></sheets></workbook>"},
            {"xl/_rels/workbook.xml.rels",
             "<Relationships><Relationship Id='r1' Type='http://x/worksheet' "
             "Target='worksheets/sheet1.xml'/></Relationships>"},
            {"xl/worksheets/sheet1.xml", sheet + "</sheetData></worksheet>"}};
}

inline std::string v(double number) {
    return "<v>" + shortest_number(number) + "</v>";
}

}  // namespace covaria::readers_test
