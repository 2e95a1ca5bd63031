// Blocks of cells as text: what other programs put on the clipboard, and what they take.
#pragma once

#include <QLocale>
#include <QModelIndexList>
#include <QString>
#include <QStringList>
#include <vector>

namespace covaria::ui {

/// Rows of cells from text with tabs, semicolons or commas between them; quoted cells may hold anything.
/// A comma separates cells only where it is not the locale's decimal mark.
std::vector<QStringList> parse_block(const QString& text, const QLocale& locale);

/// Texts of the selected cells, row by row with tabs between, numbers with all their digits as a spreadsheet
/// in the user's locale takes them; cells not selected are empty. With `heads`, the column heads come first.
QString block_text(const QModelIndexList& cells, bool heads = false);
/// The text without the line of the model's column heads, where it begins with one.
QString without_heads(const QString& text, const QAbstractItemModel& model);

}  // namespace covaria::ui
