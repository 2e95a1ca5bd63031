// A paragraph of HTML set to a width: measured, then painted on a page.
#include "ui/print/rich_text.h"

#include <QAbstractTextDocumentLayout>
#include <QPainter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextOption>
#include <algorithm>
#include <cmath>

#include "ui/print/kept_spaces.h"

namespace covaria::ui {
namespace {

/// The importer of HTML makes a plain space of every other one but U+00A0: numbers would break between their
/// groups of digits. It is put back where it was.
constexpr char16_t group_space = u'\u202f', stand_in = u'\ue02f';
/// Stands behind the stroke of a unit, where a line would break else: "mm/m".
constexpr char16_t joiner = u'\u2060';

void replace(QTextDocument& document, qsizetype at, QChar letter) {
    QTextCursor cursor(&document);
    cursor.setPosition(static_cast<int>(at));
    cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
    cursor.insertText(QString(letter));
}

void insert(QTextDocument& document, qsizetype at, QChar letter) {
    QTextCursor cursor(&document);
    cursor.setPosition(static_cast<int>(at));
    cursor.insertText(QString(letter));
}

bool is_stroke_of_unit(const QString& text, qsizetype at) {
    const auto letter = [&](qsizetype i) { return i >= 0 && i < text.size() && text[i].isLetter(); };
    return text[at] == u'/' && letter(at - 1) && letter(at + 1);
}

void set_html(QTextDocument& document, QString html) {
    document.setHtml(html.replace(group_space, stand_in));
    const QString set = document.toRawText();
    const QString kept = with_kept_spaces(QString(set).replace(stand_in, group_space));
    for (qsizetype i = set.size(); i-- > 0;) {
        if (kept[i] != set[i]) replace(document, i, kept[i]);
        if (is_stroke_of_unit(set, i)) insert(document, i + 1, joiner);
    }
}

/// Whether lines may break on either side of it without a space: letters of Chinese, Japanese and Korean.
bool is_ideograph(QChar letter) {
    return letter.unicode() >= 0x2e80 && !letter.isSurrogate();
}

bool breaks(QChar letter) {
    return letter == ' ' || letter == QChar::LineSeparator || letter == QChar::ParagraphSeparator;
}

/// The longest part of a text that no line breaks.
double longest_word(const QString& text, const QFontMetricsF& metrics) {
    double widest = 0.0;
    qsizetype begin = 0;
    for (qsizetype i = 0; i <= text.size(); ++i) {
        const bool end = i == text.size() || breaks(text[i]) || is_ideograph(text[i]);
        if (!end) continue;
        widest = std::max(widest, metrics.horizontalAdvance(text.sliced(begin, i - begin)));
        if (i < text.size() && is_ideograph(text[i]))
            widest = std::max(widest, metrics.horizontalAdvance(text[i]));
        begin = i + 1;
    }
    return widest;
}

}  // namespace

RichText::RichText(const PageStyle& style, TextRole role, const QString& html, Qt::Alignment align)
    : document_(std::make_shared<QTextDocument>()) {
    document_->documentLayout()->setPaintDevice(style.device());
    document_->setUseDesignMetrics(true);
    document_->setDefaultFont(style.font(role));
    document_->setDocumentMargin(0.0);
    QTextOption option(align);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    document_->setDefaultTextOption(option);
    set_html(*document_, html);
    document_->setTextWidth(-1.0);
}

double RichText::natural_width() const {
    const double kept = document_->textWidth();
    document_->setTextWidth(-1.0);
    const double width = std::ceil(document_->idealWidth()) + 1.0;
    document_->setTextWidth(kept);
    return width;
}

double RichText::narrowest_width() const {
    const QFontMetricsF metrics(document_->defaultFont(), document_->documentLayout()->paintDevice());
    return std::ceil(1.02 * longest_word(document_->toRawText(), metrics)) + 1.0;
}

void RichText::set_width(double width) {
    document_->setTextWidth(width);
}

double RichText::height() const {
    return document_->size().height();
}

double RichText::first_baseline() const {
    document_->documentLayout()->documentSize();  // lays the text out
    const QTextLayout* layout = document_->firstBlock().layout();
    return layout->lineCount() > 0 ? layout->lineAt(0).ascent() : 0.0;
}

void RichText::paint(QPainter& painter, QPointF top_left, const QColor& color) const {
    painter.save();
    painter.translate(top_left);
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, color);
    document_->documentLayout()->draw(&painter, context);
    painter.restore();
}

}  // namespace covaria::ui
