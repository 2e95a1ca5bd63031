// Tables of a printed report: column widths, rows as flow items, heads repeated on every page.
#pragma once

#include <vector>

#include "core/document/report_document.h"
#include "ui/print/flow.h"
#include "ui/print/page_style.h"

namespace covaria::ui {

/// Widths that a column of a table wants: on one line, and at the least (longest word).
struct ColumnWish {
    double natural = 0.0;
    double narrowest = 0.0;
    bool numeric = false;  ///< numbers are never squeezed
};
/// Widths that fill at most `available`: natural ones if they fit, else text columns give way in proportion,
/// to their narrowest and no further.
std::vector<double> share_width(const std::vector<ColumnWish>& wishes, double available);

/// Appends caption, head, rows and notes of the table, to be set `width` wide at most. What is too wide gets
/// smaller letters; what is too wide even so, further parts below the first, with its first columns repeated.
void append_table(std::vector<FlowItem>& items, const TableBlock& block, const PageStyle& style,
                  double width);

}  // namespace covaria::ui
