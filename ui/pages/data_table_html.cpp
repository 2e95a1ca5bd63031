#include "ui/pages/data_table_html.h"

#include <QObject>

#include "core/text/cell.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr std::size_t most_rows = 300;

QString element(const char* tag, bool is_numeric, const QString& content) {
    return QStringLiteral("<%1 align=\"%2\">%3</%1>")
        .arg(QLatin1String(tag), QLatin1String(is_numeric ? "right" : "left"), content);
}

/// A text in the user's numbers. HTML breaks lines at the narrow space between groups of digits, so it goes.
QString shown(const Text& text) {
    return to_qt(to_html(text)).replace(QChar(0x202f), QChar(QChar::Nbsp));
}

QString html_of(const Table& made) {
    const TableView view{{}, 2, language_of_window()};
    const Table table = evaluation_table(made, view.language);
    std::vector<bool> is_numeric;
    QString html = QStringLiteral("<h4>%1</h4><table cellpadding=\"3\" cellspacing=\"0\"><tr>")
                       .arg(to_qt(table.title).toHtmlEscaped());
    for (const Column& column : table.columns) {
        is_numeric.push_back(has_only_numbers(table, column));
        html += element("th", is_numeric.back(), shown(head_written(column, view)));
    }
    html += QStringLiteral("</tr>");
    for (std::size_t r = 0; r < std::min(table.rows, most_rows); ++r) {
        html += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            html += element("td", is_numeric[i], shown(written(table, table.columns[i], r, view)));
        html += QStringLiteral("</tr>");
    }
    html += QStringLiteral("</table>");
    if (table.rows > most_rows)
        html += QObject::tr("<p>%1 more rows; the exported table has all of them.</p>")
                    .arg(table.rows - most_rows);
    for (const Message& note : table.notes)
        html += QStringLiteral("<p>%1</p>").arg(to_qt(note).toHtmlEscaped());
    return html;
}

}  // namespace

QString html_of(const std::vector<Table>& tables) {
    QString html;
    for (const Table& table : tables) html += html_of(table);
    return html;
}

}  // namespace covaria::ui
