#include "ui/pages/help_pane.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>

#include "core/document/document_writers.h"
#include "core/manual/markdown.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

/// Quiet rules, and room in the cells.
void dress_tables(QTextDocument& document, const QColor& rule) {
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (!table) continue;
        QTextTableFormat format = table->format();
        format.setCellPadding(4.0);
        format.setCellSpacing(0.0);
        format.setBorderCollapse(true);
        format.setBorder(0.5);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(rule);
        table->setFormat(format);
    }
}

/// Equations as text: text browsers set no MathML.
std::vector<ReportBlock> browsable(std::vector<ReportBlock> blocks) {
    for (ReportBlock& block : blocks)
        if (auto* equation = std::get_if<EquationBlock>(&block)) {
            equation->formula = {};
            if (!equation->source.empty()) equation->source = "   (" + equation->source + ")";
        }
    return blocks;
}

}  // namespace

HelpPane::HelpPane(QWidget* parent) : QWidget(parent), browser_(new QTextBrowser(this)) {
    browser_->setObjectName(QStringLiteral("help"));
    browser_->setAccessibleName(tr("Help"));
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->setOpenLinks(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(browser_);
    setFocusProxy(browser_);
    connect(browser_, &QTextBrowser::anchorClicked, this, &HelpPane::follow);
}

const std::vector<HelpPage>& HelpPane::pages() {
    if (pages_.empty())
        if (auto read = help_pages(language_of_window())) pages_ = std::move(*read);
    return pages_;
}

const HelpPage* HelpPane::page_of(const QString& anchor) {
    const std::string wanted = to_std(anchor);
    const HelpPage* found = nullptr;
    for (const HelpPage& page : pages())
        if ((wanted == page.id || wanted.starts_with(page.id + "-")) &&
            (!found || page.id.size() > found->id.size()))
            found = &page;
    return found;
}

bool HelpPane::has_place(const QString& anchor) {
    return page_of(anchor) != nullptr;
}

bool HelpPane::show_place(const QString& anchor) {
    const HelpPage* found = page_of(anchor);
    if (!found) return false;
    if (page_ != found->id) show_blocks(to_qt(found->title), found->blocks);
    page_ = found->id;
    place_ = anchor;
    go_to_place();
    QMetaObject::invokeMethod(this, &HelpPane::go_to_place, Qt::QueuedConnection);  // at its new width
    return true;
}

void HelpPane::show_words(const QString& title, const QString& markdown) {
    page_.clear();
    place_.clear();
    show_blocks(title, blocks_of_markdown(to_std(markdown), "words"));
}

void HelpPane::show_blocks(const QString& title, const std::vector<ReportBlock>& blocks) {
    // Dressed before it is laid out: what stands below tables that change afterwards is not drawn.
    auto* document = new QTextDocument(browser_);
    document->setDefaultFont(browser_->font());
    document->setDocumentMargin(16);
    document->setHtml(to_qt(html_body(browsable(blocks))));
    dress_tables(*document, palette().color(QPalette::Mid));
    browser_->setDocument(document);
    emit title_changed(title);
}

QTextBlock HelpPane::block_at_place() const {
    for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next())
        for (auto at = block.begin(); !at.atEnd(); ++at)
            if (at.fragment().charFormat().anchorNames().contains(place_)) return block;
    return {};
}

QString HelpPane::words_at_place() const {
    return block_at_place().text();
}

/// The top of a page stands as it is, a place in it is marked.
void HelpPane::go_to_place() {
    browser_->setExtraSelections({});
    const QTextBlock block = block_at_place();
    const bool is_top = !block.isValid() || to_std(place_) == page_;
    browser_->scrollToAnchor(is_top ? to_qt(page_) : place_);
    browser_->horizontalScrollBar()->setValue(0);
    if (is_top) return;
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(block);
    QColor color = palette().color(QPalette::Highlight);
    color.setAlpha(60);
    mark.format.setBackground(color);
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    browser_->setExtraSelections({mark});
}

void HelpPane::follow(const QUrl& link) {
    if (link.scheme().startsWith(QStringLiteral("http"))) {
        QDesktopServices::openUrl(link);
        return;
    }
    const QString stem = QFileInfo(link.path()).completeBaseName();
    if (link.hasFragment())
        show_place(stem.isEmpty() ? link.fragment() : stem + QLatin1Char('-') + link.fragment());
    else if (!show_place(stem))
        show_place(QStringLiteral("model-") + stem);
}

}  // namespace covaria::ui
