// Tables of evaluations as text for a QTextBrowser.
#pragma once

#include <QString>
#include <vector>

#include "core/text/table.h"

namespace covaria::ui {

/// Title, head, rows and notes of each table; of very long tables the first rows.
QString html_of(const std::vector<Table>& tables);

}  // namespace covaria::ui
