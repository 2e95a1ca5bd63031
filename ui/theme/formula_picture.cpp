// Boxes with a baseline, put together from the inside out.
#include "ui/theme/formula_picture.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "ui/theme/fonts.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

using Box = FormulaPicture::Box;
using K = Formula::Kind;

class FormulaSetter {
public:
    explicit FormulaSetter(QPaintDevice* device) : device_(device) {}

    Box formula(const Formula& f, const QFont& font) const {
        switch (f.kind) {
            case K::symbol:
                return symbol(f.symbol, font);
            case K::number:
            case K::word:
                return text(to_qt(f.text), font, false);
            case K::sign:
                return sign(to_qt(f.text), font);
            case K::row:
                return row(parts(f, font), font);
            case K::fraction:
                return fraction(parts(f, font), font);
            case K::power:
                return with_scripts(formula(f.parts.at(0), font), {}, formula(f.parts.at(1), smaller(font)),
                                    font);
            case K::root:
                return root(formula(f.parts.at(0), font), to_qt(f.text), font);
            case K::fence:
                return fence(formula(f.parts.at(0), font), to_qt(f.text), font);
        }
        return {};
    }

    Box words(const Text& words, const QFont& font) const {
        const QFont symbols = formula_font(font);
        Box line, last;  // a script hangs on the last letters, however low an earlier one goes
        for (const Text::Span& span : words.spans()) {
            const QFont& own = span.italic ? symbols : font;
            const Box part = span.script == Script::line ? text(to_qt(span.letters), own, span.italic)
                                                         : script(span.letters, font);
            if (span.script == Script::line) line = beside(std::move(line), std::exchange(last, part));
            if (span.script == Script::below) last = with_scripts(std::move(last), part, {}, font);
            if (span.script == Script::above) last = with_scripts(std::move(last), {}, part, font);
        }
        return beside(std::move(line), last);
    }

private:
    QFontMetricsF metrics(const QFont& font) const {
        return device_ ? QFontMetricsF(font, device_) : QFontMetricsF(font);
    }
    double em(const QFont& font) const { return metrics(font).height() * 0.8; }
    /// Height of fraction bars and of the middle of operators above the baseline.
    double axis(const QFont& font) const { return 0.5 * metrics(font).xHeight(); }

    static QFont smaller(QFont font) {
        if (font.pointSizeF() > 0)
            font.setPointSizeF(std::max(5.0, 0.72 * font.pointSizeF()));
        else
            font.setPixelSize(std::max(6, qRound(0.72 * font.pixelSize())));
        return font;
    }

    static void put(Box& into, const Box& part, double x, double down) {
        for (FormulaPicture::Piece text : part.texts) {
            text.at += QPointF(x, down);
            into.texts.push_back(text);
        }
        into.filled.addPath(part.filled.translated(x, down));
        into.drawn.addPath(part.drawn.translated(x, down));
        into.pen = std::max(into.pen, part.pen);
        into.width = std::max(into.width, x + part.width);
        into.ascent = std::max(into.ascent, part.ascent - down);
        into.descent = std::max(into.descent, part.descent + down);
    }

    Box text(const QString& words, QFont font, bool italic) const {
        font.setItalic(italic);
        const QFontMetricsF m = metrics(font);
        Box box;
        box.width = m.horizontalAdvance(words) + (italic ? 0.06 * em(font) : 0.0);
        box.ascent = 0.85 * m.ascent();
        box.descent = m.descent();
        box.texts.push_back({QPointF(0.0, 0.0), words, font});
        return box;
    }

    QVector<Box> parts(const Formula& f, const QFont& font) const {
        QVector<Box> all;
        for (const Formula& part : f.parts) all.push_back(formula(part, font));
        return all;
    }

    static Box beside(Box left, const Box& right) {
        put(left, right, left.width, 0.0);
        return left;
    }

    /// Letters below or above a box that has this font.
    Box script(const std::string& letters, const QFont& font) const {
        Box box;
        for (const ScriptPart& part : script_parts(letters))
            box = beside(std::move(box), text(to_qt(part.letters), smaller(font), part.italic));
        return box;
    }

    /// Single letters, with an accent or a Δ, are variables; longer ones are words.
    Box symbol(const Symbol& s, const QFont& font) const {
        const QString base = to_qt(s.base);
        return with_scripts(base.isEmpty() ? Box{} : text(base, font, base.size() <= 2),
                            script(s.subscript, font), script(s.superscript, font), font);
    }

    Box sign(const QString& words, const QFont& font) const {
        const bool is_tight = words == QString::fromUtf8("·");
        const bool is_comma = words == QLatin1String(",") || words == QLatin1String(";");
        const double space = is_tight ? 0.12 * em(font) : 0.26 * em(font);
        const Box inner = text(words, font, false);
        Box box;
        put(box, inner, is_comma ? 0.0 : space, 0.0);
        box.width = inner.width + (is_comma ? 1.0 : 2.0) * space;
        return box;
    }

    /// Parts side by side.
    Box row(const QVector<Box>& all, const QFont& font) const {
        Box box;
        for (int i = 0; i < all.size(); ++i) {
            // A sign at the begin of a row is no operator between two things.
            const bool leading = i == 0 && all.size() > 1 && all[i].texts.size() == 1 &&
                                 all[i].filled.isEmpty() && all[i].texts[0].text == QChar(0x2212);
            put(box, all[i], leading ? -0.2 * em(font) : box.width, 0.0);
            if (leading) box.width -= 0.2 * em(font);
        }
        return box;
    }

    /// Parentheses or bars, which grow with what is between them.
    Box fence(const Box& inside, const QString& open, const QFont& font) const {
        const QString close = open == QLatin1String("(") ? QStringLiteral(")") : open;
        const Box plain = text(QStringLiteral("("), font, false);
        const bool grows = inside.ascent > 1.3 * plain.ascent || inside.descent > 1.9 * plain.descent;
        const auto mark = [&](const QString& which) {
            return grows ? tall(which, font, inside.ascent, inside.descent) : text(which, font, false);
        };
        return beside(beside(mark(open), inside), mark(close));
    }

    /// A letter drawn higher than it is, not its outline: who reads the text of a document finds it.
    Box tall(const QString& mark, const QFont& font, double ascent, double descent) const {
        const QFontMetricsF m = metrics(font);
        const QRectF outline = m.tightBoundingRect(mark);
        const double higher = (ascent + descent) / std::max(outline.height(), 1e-9);
        Box box;
        box.width = m.horizontalAdvance(mark);
        box.ascent = ascent;
        box.descent = descent;
        box.texts.push_back({QPointF(0.0, -ascent - higher * outline.top()), mark, font, higher});
        return box;
    }

    Box fraction(const QVector<Box>& both, const QFont& font) const {
        if (both.size() != 2) return {};
        const double gap = 0.12 * em(font), bar = 0.06 * em(font), side = 0.1 * em(font);
        const double width = std::max(both[0].width, both[1].width) + 2.0 * side, middle = -axis(font);
        Box box;
        put(box, both[0], 0.5 * (width - both[0].width), middle - 0.5 * bar - gap - both[0].descent);
        put(box, both[1], 0.5 * (width - both[1].width), middle + 0.5 * bar + gap + both[1].ascent);
        box.filled.addRect(QRectF(0.04 * em(font), middle - 0.5 * bar, width - 0.08 * em(font), bar));
        box.width = width;
        return box;
    }

    /// The base with its scripts, of which either may be empty.
    Box with_scripts(Box base, const Box& below, const Box& above, const QFont& font) const {
        Box box = base;
        const double x = base.width + 0.03 * em(font);
        if (!below.texts.isEmpty()) put(box, below, x, base.descent + 0.1 * below.ascent);
        if (!above.texts.isEmpty()) put(box, above, x, -(base.ascent - 0.45 * above.ascent));
        return box;
    }

    Box root(const Box& inside, const QString& degree, const QFont& font) const {
        const double gap = 0.12 * em(font), lead = 0.62 * em(font);
        const double top = -(inside.ascent + gap), bottom = inside.descent;
        Box box;
        put(box, inside, lead, 0.0);
        box.drawn.moveTo(0.06 * em(font), 0.45 * top);
        box.drawn.lineTo(0.2 * em(font), 0.5 * top);
        box.drawn.lineTo(0.38 * em(font), bottom);
        box.drawn.lineTo(0.56 * em(font), top);
        box.drawn.lineTo(lead + inside.width + 0.08 * em(font), top);
        box.pen = std::max(box.pen, 0.055 * em(font));
        box.width = lead + inside.width + 0.12 * em(font);
        box.ascent = std::max(box.ascent, -top + box.pen);
        if (!degree.isEmpty()) put(box, text(degree, smaller(smaller(font)), false), 0.0, 0.62 * top);
        return box;
    }

    QPaintDevice* device_;
};

}  // namespace

FormulaPicture::FormulaPicture(const Formula& formula, const QFont& font, QPaintDevice* device)
    : box_(FormulaSetter(device).formula(formula, formula_font(font))) {}

FormulaPicture::FormulaPicture(const Text& text, const QFont& font, QPaintDevice* device)
    : box_(FormulaSetter(device).words(text, font)) {}

void FormulaPicture::paint(QPainter& painter, QPointF top_left, const QColor& color) const {
    painter.save();
    painter.translate(top_left + QPointF(0.0, box_.ascent));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(color);
    for (const Piece& text : box_.texts) {
        painter.setFont(text.font);
        painter.save();
        painter.translate(text.at);
        painter.scale(1.0, text.stretch);
        painter.drawText(QPointF(0.0, 0.0), text.text);
        painter.restore();
    }
    painter.fillPath(box_.filled, color);
    painter.strokePath(box_.drawn, QPen(color, box_.pen, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.restore();
}

}  // namespace covaria::ui
