// The verdicts that tables of an evaluation bear, out of their tables: one a row, for whoever judges a
// project.
#pragma once

#include <cstddef>
#include <vector>

#include "core/text/cell.h"
#include "core/text/table.h"

namespace covaria {

/// A row with a verdict.
struct DecidedRow {
    Text subject;  ///< "Decisions after ISO 14253-1: P3, length"
    TestVerdict verdict;
    Text figures;  ///< "E = 12.3 µm, U = 4.0 µm, MPE = 10.5 µm"
};

/// All of them, in the order of the tables.
std::vector<DecidedRow> decisions_in(const std::vector<Table>& tables, const TableView& view = {});

/// How many rows bear this verdict.
std::size_t count_of(const std::vector<DecidedRow>& rows, TestVerdict::Is is);

}  // namespace covaria
