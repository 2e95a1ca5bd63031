// Runs of text on the line and below it.
#include "ui/theme/label_text.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

namespace covaria::ui {
namespace {

constexpr double small_size = 0.74, lowering = 0.16;  // of the font's size

const QString& unicode_subscripts() {
    static const QString letters = QStringLiteral("₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ");
    return letters;
}

QChar plain(QChar subscript) {
    static const QString letters = QStringLiteral("0123456789+−=()aehijklmnoprstuvxβγρφχ");
    const auto index = unicode_subscripts().indexOf(subscript);
    return index < 0 ? subscript : letters[index];
}

constexpr int longest_base = 2;  // letters of a symbol, "ΔT_1": "base_points" is a word

bool starts_subscript(const QString& text, qsizetype i) {
    if (text[i] != u'_' || i + 1 >= text.size() || !text[i + 1].isLetterOrNumber()) return false;
    int letters = 0;
    for (qsizetype k = i - 1; k >= 0 && (text[k].isLetterOrNumber() || text[k].isMark() || text[k] == u'_');
         --k)
        if (!text[k].isMark()) ++letters;
    return letters >= 1 && letters <= longest_base && !text[i - 1].isDigit();
}

/// A comma within a subscript, "p_1x,1", but not the one after it, "p_1x, pose 1".
bool goes_on(const QString& text, qsizetype i) {
    return text[i].isLetterOrNumber() ||
           (text[i] == u',' && i + 1 < text.size() && text[i + 1].isLetterOrNumber());
}

}  // namespace

LabelText::LabelText(const QString& text, const QFont& font) : font_(font), small_(font) {
    const int size = font.pixelSize() > 0 ? font.pixelSize() : QFontInfo(font).pixelSize();
    small_.setPixelSize(std::max(1, qRound(small_size * size)));
    lowering_ = lowering * size;
    QString run;
    bool lowered = false, after_underscore = false;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (starts_subscript(text, i)) {
            append(run, lowered);
            run.clear();
            lowered = after_underscore = true;
            continue;
        }
        const bool is_subscript = unicode_subscripts().contains(text[i]);
        if (after_underscore && !goes_on(text, i)) after_underscore = false;
        const bool now = is_subscript || after_underscore;
        if (now != lowered) {
            append(run, lowered);
            run.clear();
            lowered = now;
        }
        run += is_subscript ? plain(text[i]) : text[i];
    }
    append(run, lowered);
}

void LabelText::append(const QString& text, bool lowered) {
    if (text.isEmpty()) return;
    const double width = QFontMetricsF(lowered ? small_ : font_).horizontalAdvance(text);
    runs_.push_back({text, lowered, width});
    width_ += width;
}

bool LabelText::has_subscripts() const {
    return std::any_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.lowered; });
}

double LabelText::height() const {
    return QFontMetricsF(font_).height();
}

void LabelText::draw(QPainter& painter, QPointF top_left) const {
    QPointF baseline = top_left + QPointF(0.0, QFontMetricsF(font_).ascent());
    for (const Run& run : runs_) {
        painter.setFont(run.lowered ? small_ : font_);
        painter.drawText(baseline + QPointF(0.0, run.lowered ? lowering_ : 0.0), run.text);
        baseline.rx() += run.width;
    }
}

QString shortened(const QString& text, const QFont& font, double width) {
    if (LabelText(text, font).width() <= width) return text;
    return QFontMetricsF(font).elidedText(text, Qt::ElideMiddle, width);
}

QStringList wrapped(const QString& text, const QFont& font, double width) {
    QStringList lines;
    for (const QString& word : text.split(u' ')) {
        const QString longer = lines.isEmpty() ? word : lines.constLast() + u' ' + word;
        if (lines.isEmpty())
            lines << word;
        else if (LabelText(longer, font).width() <= width)
            lines.last() = longer;
        else
            lines << word;
    }
    return lines;
}

}  // namespace covaria::ui
