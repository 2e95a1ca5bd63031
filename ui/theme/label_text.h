// Text with real subscripts, in charts, tables and lists: "b_1x" and "bₓ" are both set with small, lowered
// letters.
#pragma once

#include <QFont>
#include <QString>
#include <QStringList>
#include <vector>

class QPainter;
class QPointF;

namespace covaria::ui {

class LabelText {
public:
    LabelText(const QString& text, const QFont& font);
    double width() const { return width_; }
    double height() const;
    /// False: the text looks as any other would draw it.
    bool has_subscripts() const;
    /// Draws with the painter's pen; `top_left` of a box of width() times height().
    void draw(QPainter& painter, QPointF top_left) const;

private:
    struct Run {
        QString text;
        bool lowered;
        double width;
    };
    void append(const QString& text, bool lowered);
    QFont font_, small_;
    std::vector<Run> runs_;
    double width_ = 0.0, lowering_ = 0.0;
};

/// `text` cut in the middle, marked by an ellipsis, where it is wider than `width`.
QString shortened(const QString& text, const QFont& font, double width);
/// Lines no wider than `width` where words allow it.
QStringList wrapped(const QString& text, const QFont& font, double width);

}  // namespace covaria::ui
