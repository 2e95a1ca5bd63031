// A number of a table, set to its decimal sign.
#pragma once

#include <QFont>
#include <QString>

#include "ui/print/page_style.h"

class QPainter;

namespace covaria {
struct NumberLocale;
}

namespace covaria::ui {

class NumberText {
public:
    NumberText(const PageStyle& style, const QString& text, const NumberLocale& locale);
    double before_point() const { return before_; }
    double after_point() const { return after_; }  ///< the sign included
    void paint(QPainter& painter,
               QPointF point) const;  ///< `point`: where its decimal sign stands on the baseline

private:
    QString text_;
    QFont font_;
    double before_ = 0.0, after_ = 0.0;
};

/// Index at which the decimal sign of a number stands, or would stand: "5×10⁻⁵" is aligned behind the 5.
qsizetype decimal_sign_of(const QString& number, const NumberLocale& locale);

}  // namespace covaria::ui
