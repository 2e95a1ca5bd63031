#include "ui/pages/data_table_html.h"

#include <QObject>

#include "core/base/message.h"
#include "core/report/table_text.h"
#include "core/text/head_with_unit.h"
#include "core/text/symbol.h"
#include "ui/models/number_words.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t most_rows = 300;

QString element(const char* tag, bool is_numeric, const QString& content) {
    return QStringLiteral("<%1 align=\"%2\">%3</%1>")
        .arg(QLatin1String(tag), QLatin1String(is_numeric ? "right" : "left"), content);
}

QString head_of(const TableColumn& column) {
    const Text name = column.is_symbol ? symbols_text(column.header) : Text(to_std(core_text(column.header)));
    return to_qt(to_html(head_with_unit(name, column.unit)));
}

/// As in a report, in the user's numbers. The narrow space between groups would be read as one to break at.
QString shown(const TableBlock& block, std::size_t row, std::size_t column) {
    const TableCell& cell = block.table.rows[row][column];
    const auto* words = std::get_if<Message>(&cell);
    return to_qt(to_html(words ? running_text(to_std(to_qt(*words))) : cell_typeset(block, row, column)))
        .replace(QChar(0x202f), QChar(QChar::Nbsp));
}

QString html_of(const DataTable& as_made) {
    const TableBlock block = read_table(as_made, user_numbers());
    const DataTable& table = block.table;
    std::vector<bool> is_numeric;
    QString html = QStringLiteral("<h4>%1</h4><table cellpadding=\"3\" cellspacing=\"0\"><tr>")
                       .arg(core_text(table.title).toHtmlEscaped());
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        is_numeric.push_back(is_numeric_column(block, i));
        html += element("th", is_numeric[i], head_of(table.columns[i]));
    }
    html += QStringLiteral("</tr>");
    for (std::size_t r = 0; r < std::min(table.rows.size(), most_rows); ++r) {
        html += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < std::min(table.rows[r].size(), table.columns.size()); ++i)
            html += element("td", is_numeric[i], shown(block, r, i));
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
