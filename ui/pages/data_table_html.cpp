#include "ui/pages/data_table_html.h"

#include <QObject>

#include "core/base/message.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "ui/models/number_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t most_rows = 300;

QString head_of(const TableColumn& column) {
    QString head = column.is_symbol ? to_qt(to_html(symbols_text(column.header)))
                                    : core_text(column.header).toHtmlEscaped();
    if (!(column.unit == Unit())) head += QStringLiteral("<br>(%1)").arg(to_qt(column.unit.display()));
    return QStringLiteral("<th align=\"right\">%1</th>").arg(head);
}

/// Numbers as everywhere in the window: the locale's decimal mark, a true minus sign. Symbols among words are
/// set as symbols.
QString shown(const TableCell& cell, const TableColumn& column) {
    if (const auto* words = std::get_if<Message>(&cell))
        return to_qt(to_html(running_text(to_std(to_qt(*words)))));
    const std::string text = format_cell(cell, column);
    return std::holds_alternative<std::string>(cell) ? to_qt(to_html(running_text(text)))
                                                     : localized(text).toHtmlEscaped();
}

QString html_of(const DataTable& table) {
    QString html = QStringLiteral("<h4>%1</h4><table cellpadding=\"3\" cellspacing=\"0\"><tr>")
                       .arg(core_text(table.title).toHtmlEscaped());
    for (const TableColumn& column : table.columns) html += head_of(column);
    html += QStringLiteral("</tr>");
    for (std::size_t r = 0; r < std::min(table.rows.size(), most_rows); ++r) {
        const auto& row = table.rows[r];
        html += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < row.size() && i < table.columns.size(); ++i)
            html += QStringLiteral("<td align=\"right\">%1</td>").arg(shown(row[i], table.columns[i]));
        html += QStringLiteral("</tr>");
    }
    html += QStringLiteral("</table>");
    if (table.rows.size() > most_rows)
        html += QObject::tr("<p>%1 more rows; the exported table has all of them.</p>")
                    .arg(table.rows.size() - most_rows);
    for (const Message& note : table.notes)
        html += QStringLiteral("<p>%1</p>").arg(to_qt(note).toHtmlEscaped());
    return html;
}

}  // namespace

QString html_of(const std::vector<DataTable>& tables) {
    QString html;
    for (const DataTable& table : tables) html += html_of(table);
    return html;
}

}  // namespace covaria::ui
