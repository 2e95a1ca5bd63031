// Boxes with a baseline, put together from the inside out.
#include "ui/theme/formula_picture.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QXmlStreamReader>
#include <algorithm>

namespace covaria::ui {

namespace {

using Box = FormulaPicture::Box;

class Setter {
public:
    Setter(const QString& mathml, const QFont& font, QPaintDevice* device)
        : reader_(mathml), font_(font), device_(device) {}

    Box run() { return reader_.readNextStartElement() ? element(font_) : Box{}; }

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
        for (FormulaPicture::Text text : part.texts) {
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

    Box element(const QFont& font) {
        const QString name = reader_.name().toString();
        if (name == QLatin1String("mi") || name == QLatin1String("mn") || name == QLatin1String("mtext")) {
            const QString words = reader_.readElementText();
            const bool is_variable = name == QLatin1String("mi") && words.size() <= 2;
            return text(words, font, is_variable);
        }
        if (name == QLatin1String("mo")) return sign(reader_.readElementText(), font);
        if (name == QLatin1String("mfrac")) return fraction(font);
        if (name == QLatin1String("msup")) return script(font, true);
        if (name == QLatin1String("msub")) return script(font, false);
        if (name == QLatin1String("msqrt") || name == QLatin1String("mroot")) return root(font);
        return row(font);
    }

    QVector<Box> parts(const QFont& font) {
        QVector<Box> all;
        while (reader_.readNextStartElement()) all.push_back(element(font));
        return all;
    }

    Box sign(const QString& words, const QFont& font) const {
        const bool is_fence =
            words == QLatin1String("(") || words == QLatin1String(")") || words == QLatin1String("|");
        const bool is_tight = words == QString::fromUtf8("·");
        const bool is_comma = words == QLatin1String(",") || words == QLatin1String(";");
        const double space = is_fence ? 0.0 : is_tight ? 0.12 * em(font) : 0.26 * em(font);
        const Box inner = text(words, font, false);
        Box box;
        put(box, inner, is_comma ? 0.0 : space, 0.0);
        box.width = inner.width + (is_comma ? 1.0 : 2.0) * space;
        return box;
    }

    /// Parts side by side; a first and a last parenthesis grow with what is between them.
    Box row(const QFont& font) {
        QVector<Box> all = parts(font);
        const auto is = [&](const Box& box, const char* mark) {
            return box.texts.size() == 1 && box.filled.isEmpty() && box.texts[0].text == QLatin1String(mark);
        };
        if (all.size() >= 2 && (is(all.first(), "(") || is(all.first(), "|"))) fence(all, font);
        Box box;
        for (int i = 0; i < all.size(); ++i) {
            // A sign at the begin of a row is no operator between two things.
            const bool leading = i == 0 && is(all[i], "\u2212") && all.size() > 1;
            put(box, all[i], leading ? -0.2 * em(font) : box.width, 0.0);
            if (leading) box.width -= 0.2 * em(font);
        }
        return box;
    }

    void fence(QVector<Box>& all, const QFont& font) const {
        double ascent = 0.0, descent = 0.0;
        for (int i = 1; i + 1 < all.size(); ++i) {
            ascent = std::max(ascent, all[i].ascent);
            descent = std::max(descent, all[i].descent);
        }
        const Box plain = text(QStringLiteral("("), font, false);
        if (ascent <= 1.3 * plain.ascent && descent <= 1.9 * plain.descent) return;
        for (int i : {0, int(all.size()) - 1}) all[i] = tall(all[i].texts[0].text, font, ascent, descent);
    }

    Box tall(const QString& mark, const QFont& font, double ascent, double descent) const {
        QPainterPath glyph;
        glyph.addText(0.0, 0.0, font, mark);
        // Outlines have the logical size of the font: bring them to the size on the device.
        const QRectF outline = glyph.boundingRect();
        Box box;
        box.width = metrics(font).horizontalAdvance(mark);
        box.ascent = ascent;
        box.descent = descent;
        const double width = std::min(box.width, 0.6 * box.width);
        QTransform stretch;
        stretch.translate(0.5 * (box.width - width), -ascent);
        stretch.scale(width / std::max(outline.width(), 1e-9),
                      (ascent + descent) / std::max(outline.height(), 1e-9));
        stretch.translate(-outline.left(), -outline.top());
        box.filled = stretch.map(glyph);
        return box;
    }

    Box fraction(const QFont& font) {
        const QVector<Box> both = parts(font);
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

    Box script(const QFont& font, bool above) {
        if (!reader_.readNextStartElement()) return {};
        Box box = element(font);
        if (!reader_.readNextStartElement()) return box;
        const Box small = element(smaller(font));
        reader_.skipCurrentElement();
        const double down = above ? -(box.ascent - 0.45 * small.ascent) : box.descent + 0.1 * small.ascent;
        put(box, small, box.width + 0.03 * em(font), down);
        return box;
    }

    /// Everything inside msqrt is under the sign; mroot has one part under it and the degree.
    Box root(const QFont& font) {
        const bool with_degree = reader_.name() == QLatin1String("mroot");
        Box inside, degree;
        if (!with_degree) {
            inside = row(font);
        } else {
            const QVector<Box> both = parts(font);
            if (both.size() != 2) return {};
            inside = both[0];
            degree = text(both[1].texts.value(0).text, smaller(smaller(font)), false);
        }
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
        if (with_degree) put(box, degree, 0.0, 0.62 * top);
        return box;
    }

    QXmlStreamReader reader_;
    QFont font_;
    QPaintDevice* device_;
};

}  // namespace

FormulaPicture::FormulaPicture(const QString& mathml, const QFont& font, QPaintDevice* device)
    : box_(Setter(mathml, font, device).run()) {}

void FormulaPicture::paint(QPainter& painter, QPointF top_left, const QColor& color) const {
    painter.save();
    painter.translate(top_left + QPointF(0.0, box_.ascent));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(color);
    for (const Text& text : box_.texts) {
        painter.setFont(text.font);
        painter.drawText(text.at, text.text);
    }
    painter.fillPath(box_.filled, color);
    painter.strokePath(box_.drawn, QPen(color, box_.pen, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.restore();
}

}  // namespace covaria::ui
