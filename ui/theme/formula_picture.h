// A formula given as MathML, set as mathematics: fractions with bars, roots, raised and lowered scripts.
#pragma once

#include <QColor>
#include <QFont>
#include <QPainterPath>
#include <QString>
#include <QVector>

class QPainter;
class QPaintDevice;

namespace covaria::ui {

/// Understands math, mrow, mi, mn, mo, mtext, mfrac, msup, msub, msqrt and mroot, which is what Covaria
/// writes.
class FormulaPicture {
public:
    /// Measured for `device`; null: the screen.
    FormulaPicture(const QString& mathml, const QFont& font, QPaintDevice* device = nullptr);

    bool is_empty() const { return box_.texts.isEmpty(); }
    double width() const { return box_.width; }
    double height() const { return box_.ascent + box_.descent; }
    double baseline() const { return box_.ascent; }  ///< below the top
    void paint(QPainter& painter, QPointF top_left, const QColor& color) const;

    struct Text {
        QPointF at;  ///< of its baseline
        QString text;
        QFont font;
    };
    struct Box {
        double width = 0.0, ascent = 0.0, descent = 0.0;
        QVector<Text> texts;
        QPainterPath filled;  ///< fraction bars, parentheses
        QPainterPath drawn;   ///< root signs
        double pen = 0.0;     ///< of what is drawn
    };

private:
    Box box_;
};

}  // namespace covaria::ui
