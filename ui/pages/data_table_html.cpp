#include "ui/pages/data_table_html.h"

#include <QObject>

#include "core/text/cell.h"
#include "core/text/row_links.h"
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

/// The text of a hidden column of a row; empty where there is none.
QString hidden_text(const Table& table, const char* key, std::size_t row) {
    const Column* column = table.find(key);
    return column ? to_qt(english_of(column->cell(row))) : QString();
}

/// The row's name, which leads to the reading that the row is about.
QString link_to_place(const Table& table, std::size_t row, const QString& text) {
    const QString place = hidden_text(table, place_column, row);
    return place.isEmpty() ? text
                           : QStringLiteral("<a href=\"place:%1\" style=\"text-decoration: none\">%2</a>")
                                 .arg(place.toHtmlEscaped(), text);
}

/// What may be chosen of the row's reading, as a link.
QString offer(const Table& table, std::size_t row, const TableView& view) {
    const QString cell = hidden_text(table, cell_column, row),
                  choice = hidden_text(table, choice_column, row);
    if (cell.isEmpty() || choice.isEmpty()) return element("td", false, {});
    const Text words = written(table, table[choice_words_column], row, view);
    return element("td", false,
                   QStringLiteral("<a href=\"choose:%1?%2\">%3</a>")
                       .arg(cell.toHtmlEscaped(), choice.toHtmlEscaped(), shown(words)));
}

QString html_of(const Table& made) {
    const TableView view{{}, 2, language_of_window()};
    const Table table = evaluation_table(made, view.language);
    std::vector<bool> is_numeric;
    QString html = QStringLiteral("<h4>%1</h4><table cellpadding=\"3\" cellspacing=\"0\"><tr>")
                       .arg(to_qt(table.title).toHtmlEscaped());
    const std::size_t shown_columns = table.shown_columns();
    const bool offers = table.find(choice_column) != nullptr;  // beside the name, where they are in view
    for (std::size_t i = 0; i < shown_columns; ++i) {
        const Column& column = table.columns[i];
        is_numeric.push_back(has_only_numbers(table, column));
        html += element("th", is_numeric.back(), shown(head_written(column, view)));
        if (i == 0 && offers) html += element("th", false, {});
    }
    html += QStringLiteral("</tr>");
    for (std::size_t r = 0; r < std::min(table.rows, most_rows); ++r) {
        html += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < shown_columns; ++i) {
            const QString text = shown(written(table, table.columns[i], r, view));
            html += element("td", is_numeric[i], i == 0 ? link_to_place(table, r, text) : text);
            if (i == 0 && offers) html += offer(table, r, view);
        }
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
