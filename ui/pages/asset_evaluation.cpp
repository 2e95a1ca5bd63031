#include "ui/pages/asset_evaluation.h"

#include <QScrollBar>

#include "core/base/symbol.h"
#include "core/project/workspace.h"
#include "core/report/number_format.h"
#include "ui/document/strings.h"

namespace covaria::ui {
namespace {

QString head_of(const TableColumn& column) {
    QString head =
        column.is_symbol ? to_qt(symbol_to_html(column.header)) : to_qt(column.header).toHtmlEscaped();
    if (!(column.unit == Unit())) head += QStringLiteral("<br>(%1)").arg(to_qt(column.unit.display()));
    return QStringLiteral("<th align=\"right\">%1</th>").arg(head);
}

/// Numbers with a true minus sign.
QString shown(QString cell) {
    if (cell.size() > 1 && cell[0] == QLatin1Char('-') && cell[1].isDigit()) cell[0] = QChar(0x2212);
    return cell;
}

QString html_of(const DataTable& table) {
    QString html = QStringLiteral("<h4>%1</h4><table cellpadding=\"3\" cellspacing=\"0\"><tr>")
                       .arg(to_qt(table.title).toHtmlEscaped());
    for (const TableColumn& column : table.columns) html += head_of(column);
    html += QStringLiteral("</tr>");
    for (const auto& row : table.rows) {
        html += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < row.size() && i < table.columns.size(); ++i)
            html += QStringLiteral("<td align=\"right\">%1</td>")
                        .arg(shown(to_qt(format_cell(row[i], table.columns[i]))).toHtmlEscaped());
        html += QStringLiteral("</tr>");
    }
    html += QStringLiteral("</table>");
    for (const std::string& note : table.notes)
        html += QStringLiteral("<p>%1</p>").arg(to_qt(note).toHtmlEscaped());
    return html;
}

/// The tables of one asset, or what is wrong with it.
QString evaluation_html(const Project& project, const std::string& id) {
    Problems problems;
    const AssetLibrary assets = make_assets(project, problems);
    const AssetLibrary::Entry* entry = assets.find(id);
    if (!entry) return AssetEvaluation::tr("The asset has problems; they are listed below the scene.");
    QString html;
    for (const DataTable& table : entry->asset->evaluation()) html += html_of(table);
    return html.isEmpty()
               ? AssetEvaluation::tr("This asset is used as it is specified; nothing is evaluated.")
               : html;
}

}  // namespace

AssetEvaluation::AssetEvaluation(Document& document, std::string asset, QWidget* parent)
    : QTextBrowser(parent), document_(document), asset_(std::move(asset)), jobs_(this, Execution::threads) {
    setFrameShape(QFrame::NoFrame);
    this->document()->setDocumentMargin(10);
    setAccessibleName(tr("Evaluation of the asset"));
    connect(&document_, &Document::project_changed, this, &AssetEvaluation::refresh);
    refresh();
}

void AssetEvaluation::refresh() {
    jobs_.push([this, project = document_.snapshot(), id = asset_]() -> JobQueue::Delivery {
        const QString html = evaluation_html(*project, id);
        return [this, html] {
            const int position = verticalScrollBar()->value();
            setHtml(html);
            verticalScrollBar()->setValue(position);
        };
    });
}

}  // namespace covaria::ui
