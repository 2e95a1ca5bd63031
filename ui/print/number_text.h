// A number of a table, set to its decimal point.
#pragma once

#include <QFont>
#include <QString>

#include "ui/print/page_style.h"

class QPainter;

namespace covaria::ui {

class NumberText {
public:
    NumberText(const PageStyle& style, const QString& text);
    double before_point() const { return before_; }
    double after_point() const { return after_; }  ///< the point included
    void paint(QPainter& painter,
               QPointF point) const;  ///< `point`: where its decimal point stands on the baseline

private:
    QString text_;
    QFont font_;
    double before_ = 0.0, after_ = 0.0;
};

}  // namespace covaria::ui
