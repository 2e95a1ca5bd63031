// Parts that the style draws by itself, in the tokens of the theme.
#pragma once

#include <QStyle>

class QColor;
class QPainter;
class QRectF;

namespace covaria::ui {

/// A rounded box with a line inside its edge.
void draw_box(QPainter& painter, const QRectF& rect, const QColor& fill, const QColor& line,
              double width = 1.0);
/// An open arrow head in the middle of `rect`.
void draw_chevron(QPainter& painter, const QRectF& rect, const QColor& colour, Qt::ArrowType to);
/// A field that can be typed into or opened: its line says that it has the keyboard.
void draw_field(QPainter& painter, const QStyleOption& option, bool focused);

/// False: the element is none of ours.
bool draw_flat(QStyle::PrimitiveElement element, const QStyleOption& option, QPainter& painter,
               const QWidget* widget);
bool draw_flat(QStyle::ControlElement element, const QStyleOption& option, QPainter& painter,
               const QWidget* widget);

}  // namespace covaria::ui
