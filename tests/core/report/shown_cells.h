// The texts that writers show in the tables of a document.
#pragma once

#include <string>

#include "core/document/report_document.h"

namespace covaria::test {

inline std::string head_of(const TableBlock& block, std::size_t column) {
    return to_unicode(head_written(block.table.columns.at(column), block.view));
}

inline Text typeset_cell(const TableBlock& block, std::size_t row, std::size_t column) {
    return written(block.table, block.table.columns.at(column), row, block.view);
}

/// Numbers plain, as Markdown has them.
inline std::string plain_cell(const TableBlock& block, std::size_t row, std::size_t column) {
    return rounded(block.table, block.table.columns.at(column), row, block.view)
        .value_or(to_unicode(typeset_cell(block, row, column)));
}

inline bool is_number(const TableBlock& block, std::size_t row, std::size_t column) {
    return number_in(block.table.columns.at(column).cell(row)).has_value();
}

}  // namespace covaria::test
