#include "ui/main_window/help_actions.h"

#include <Eigen/Core>
#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>

#include "core/base/resource_path.h"
#include "core/base/version.h"
#include "core/kinds/models.h"
#include "core/text/symbol.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "viz/vtk/vtk_version.h"

namespace covaria::ui {
namespace {

QString list(const QStringList& items) {
    QString text;
    for (const QString& item : items) text += QStringLiteral("- ") + item + QLatin1Char('\n');
    return text;
}

QString shipped_page(const std::string& page) {
    QFile file(from_path(data_directory() / "resources" / "help" / page));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// "z_b" -> z with a small, lowered b: each piece of one format set anew where it has scripts.
void typeset_symbols(QTextDocument& document) {
    for (QTextBlock block = document.lastBlock(); block.isValid(); block = block.previous()) {
        std::vector<QTextFragment> fragments;
        for (auto it = block.begin(); !it.atEnd(); ++it) fragments.push_back(it.fragment());
        for (auto fragment = fragments.rbegin(); fragment != fragments.rend(); ++fragment) {
            const Text text = running_text(to_std(fragment->text()));
            if (!text.has_scripts()) continue;
            QTextCursor at(&document);
            at.setPosition(fragment->position());
            at.setPosition(fragment->position() + fragment->length(), QTextCursor::KeepAnchor);
            QTextCharFormat format = fragment->charFormat();
            at.removeSelectedText();
            for (const Text::Span& span : text.spans()) {
                format.setVerticalAlignment(span.script == Script::below   ? QTextCharFormat::AlignSubScript
                                            : span.script == Script::above ? QTextCharFormat::AlignSuperScript
                                                                           : QTextCharFormat::AlignNormal);
                at.insertText(to_qt(span.letters), format);
            }
        }
    }
}

/// Tables without a head row of empty cells, quiet rules, symbols with subscripts.
void dress(QTextDocument& document) {
    document.setIndentWidth(16.0);
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table) continue;
        QTextTableFormat format = table->format();
        format.setCellPadding(4.0);
        format.setBorderCollapse(true);
        format.setBorder(0.5);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(QApplication::palette().color(QPalette::Mid));
        table->setFormat(format);
        bool empty = true;
        for (int column = 0; column < table->columns(); ++column)
            empty = empty && table->cellAt(0, column).firstCursorPosition().block().text().isEmpty();
        if (empty) table->removeRows(0, 1);
    }
    typeset_symbols(document);
}

void show_text(QWidget& window, const QString& title, const QString& markdown) {
    auto* dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->resize(760, 640);
    auto* browser = new QTextBrowser(dialog);
    browser->setObjectName(QStringLiteral("help"));
    browser->setAccessibleName(title);
    browser->setMarkdown(markdown);
    dress(*browser->document());
    browser->setOpenExternalLinks(true);
    browser->setFrameShape(QFrame::NoFrame);
    browser->document()->setDocumentMargin(24);
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(browser);
    dialog->show();
}

void show_model(QWidget& window, const std::string& model) {
    if (const ModelDescriptor* descriptor = find_model(model))
        show_text(window, core_text(descriptor->title), help_text(model));
}

QString keys_text() {
    return tr(
        "# Keys\n\n"
        "| Key | Does |\n|---|---|\n"
        "| Ctrl+N, Ctrl+O, Ctrl+S | new, open, save |\n"
        "| Ctrl+Z, Ctrl+Y | undo, redo |\n"
        "| F5, Ctrl+F5, Esc | run this analysis, run all, stop |\n"
        "| F2, Ctrl+D, Delete | rename, duplicate, delete the selected entry |\n"
        "| Arrow keys, + and − | turn and zoom the scene |\n"
        "| 1, 2, 3, 4, F | iso, top, front, right view, fit |\n"
        "| Ctrl+C, Ctrl+V | copy and paste blocks of cells |\n"
        "| F1 | help on the model of the selected analysis |\n");
}

QString eigen_version() {
    return QStringLiteral("%1.%2.%3")
        .arg(EIGEN_WORLD_VERSION)
        .arg(EIGEN_MAJOR_VERSION)
        .arg(EIGEN_MINOR_VERSION);
}

void show_about(QWidget& window) {
    QMessageBox box(&window);
    box.setWindowTitle(tr("About Covaria"));
    box.setIconPixmap(own_icon(QStringLiteral("covaria")).pixmap(QSize(64, 64), window.devicePixelRatioF()));
    box.setText(about_text());
    box.exec();
}

}  // namespace

QString help_text(const std::string& model) {
    const ModelDescriptor* descriptor = find_model(model);
    if (!descriptor) return {};
    QStringList equations, references;
    for (const ModelEquation& equation : descriptor->equations)
        equations << QStringLiteral("`%1` (%2)").arg(to_qt(equation.text), to_qt(equation.source));
    for (const Reference& reference : descriptor->references) references << to_qt(reference.text);
    QStringList notes;
    for (const std::string& note : descriptor->notes) notes << to_qt(note);
    QString text = shipped_page(descriptor->help_page);
    if (text.isEmpty())
        text = QStringLiteral("# ") + core_text(descriptor->title) + QStringLiteral("\n\n") +
               to_qt(descriptor->summary);
    text += tr("\n\n## Equations as evaluated\n\n") + list(equations);
    text += tr("\n## Notes\n\n") + list(notes);
    return text + tr("\n## References\n\n") + list(references);
}

QString about_text() {
    return tr("<h3>Covaria %1</h3><p>Measurement uncertainty of robots and large-scale metrology.<br>"
              "Evaluates by JCGM 100, 101 and 102.</p><p>Qt %2, VTK %3, Eigen %4</p>")
        .arg(QString::fromLatin1(version()), QString::fromLatin1(qVersion()), to_qt(vtk_version()),
             eigen_version());
}

void add_help_actions(QMenu& menu, QWidget& window, Selection& selection, Document& document) {
    menu.addAction(
        tr("Help on This &Model"), QKeySequence(Qt::Key_F1), &window, [&window, &selection, &document] {
            const AnalysisEntry* analysis = document.project().find_analysis(to_std(selection.analysis()));
            if (analysis)
                show_model(window, analysis->model);
            else
                show_text(window, tr("Keys"), keys_text());
        });
    menu.actions().constLast()->setIcon(icon(QStringLiteral("help")));
    QMenu* models = menu.addMenu(tr("M&odels"));
    for (const ModelDescriptor& model : model_registry())
        models->addAction(core_text(model.title), &window,
                          [&window, id = model.id] { show_model(window, id); });
    menu.addAction(tr("&Results and Requirements"), &window, [&window] {
        show_text(window, tr("Results and requirements"), shipped_page("results.md"));
    });
    menu.addAction(tr("What Every &Analysis Has"), &window, [&window] {
        show_text(window, tr("What every analysis has"), shipped_page("analysis.md"));
    });
    menu.addAction(tr("&Keys"), &window, [&window] { show_text(window, tr("Keys"), keys_text()); });
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("about")), tr("&About Covaria"), &window,
                   [&window] { show_about(window); });
}

}  // namespace covaria::ui
