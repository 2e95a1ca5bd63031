// A formula set as mathematics: fractions with bars, roots, raised and lowered scripts.
#pragma once

#include <QColor>
#include <QFont>
#include <QPainterPath>
#include <QString>
#include <QVector>

#include "core/text/formula.h"

class QPainter;
class QPaintDevice;

namespace covaria::ui {

class FormulaPicture {
public:
    /// Measured for `device`; null: the screen.
    FormulaPicture(const Formula& formula, const QFont& font, QPaintDevice* device = nullptr);
    /// An equation that is no formula: letters with their scripts.
    FormulaPicture(const Text& text, const QFont& font, QPaintDevice* device = nullptr);

    bool is_empty() const { return box_.texts.isEmpty(); }
    double width() const { return box_.width; }
    double height() const { return box_.ascent + box_.descent; }
    double baseline() const { return box_.ascent; }  ///< below the top
    void paint(QPainter& painter, QPointF top_left, const QColor& color) const;

    struct Piece {
        QPointF at;  ///< left end of its baseline
        QString text;
        QFont font;
        double stretch = 1.0;  ///< of letters in height: 1 is none
    };
    struct Box {
        double width = 0.0, ascent = 0.0, descent = 0.0;
        QVector<Piece> texts;
        QPainterPath filled;  ///< fraction bars
        QPainterPath drawn;   ///< root signs
        double pen = 0.0;     ///< width of the lines drawn
    };

private:
    Box box_;
};

}  // namespace covaria::ui
