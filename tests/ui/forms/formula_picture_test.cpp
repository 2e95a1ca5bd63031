// Formulas set as mathematics: sizes that follow from their parts, ink where it belongs.
#include "ui/theme/formula_picture.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>

namespace covaria::ui::formula_picture_test {
namespace {

FormulaPicture picture(const char* inside) {
    return FormulaPicture(QStringLiteral("<math>%1</math>").arg(QString::fromUtf8(inside)),
                          QFont(QApplication::font().family(), 20));
}

int dark_pixels(const FormulaPicture& formula, const QRect& area) {
    QImage image(int(formula.width()) + 20, int(formula.height()) + 20, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    formula.paint(painter, {10.0, 10.0}, Qt::black);
    painter.end();
    int dark = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (area.contains(x, y) && qGray(image.pixel(x, y)) < 128) ++dark;
    return dark;
}

TEST(FormulaPicture, AFractionStacksItsParts) {
    const FormulaPicture a = picture("<mi>a</mi>"), line = picture("<mrow><mi>a</mi><mi>b</mi></mrow>");
    const FormulaPicture fraction = picture("<mfrac><mi>a</mi><mi>b</mi></mfrac>");
    EXPECT_GT(fraction.height(), 1.6 * a.height());
    EXPECT_LT(fraction.width(), line.width() + a.width());
    EXPECT_LT(a.baseline(), fraction.baseline());
    // The bar: a dark row somewhere in the middle, as wide as the fraction.
    const int middle = 10 + int(fraction.baseline());
    int widest = 0;
    for (int y = middle - 16; y < middle; ++y)
        widest = std::max(widest, dark_pixels(fraction, QRect(10, y, int(fraction.width()), 1)));
    EXPECT_GT(widest, 0.8 * fraction.width());
}

TEST(FormulaPicture, ScriptsAreSmallerAndShifted) {
    const FormulaPicture plain = picture("<mrow><mi>x</mi><mn>2</mn></mrow>");
    const FormulaPicture power = picture("<msup><mi>x</mi><mn>2</mn></msup>");
    const FormulaPicture index = picture("<msub><mi>x</mi><mn>2</mn></msub>");
    EXPECT_LT(power.width(), plain.width());
    EXPECT_GT(power.baseline(), plain.baseline());
    EXPECT_GT(index.height() - index.baseline(), plain.height() - plain.baseline());
}

TEST(FormulaPicture, ARootCoversWhatIsUnderIt) {
    const FormulaPicture inside = picture("<mrow><mi>x</mi><mo>+</mo><mi>y</mi></mrow>");
    const FormulaPicture root = picture("<msqrt><mi>x</mi><mo>+</mo><mi>y</mi></msqrt>");
    EXPECT_GT(root.width(), inside.width());
    EXPECT_GT(root.baseline(), inside.baseline());
}

TEST(FormulaPicture, WhatIsNoMathmlIsEmpty) {
    EXPECT_TRUE(FormulaPicture(QString(), QFont()).is_empty());
    EXPECT_TRUE(FormulaPicture(QStringLiteral("<math><mfrac></mfrac></math>"), QFont()).is_empty());
    EXPECT_TRUE(FormulaPicture(QStringLiteral("nonsense"), QFont()).is_empty());
}

}  // namespace
}  // namespace covaria::ui::formula_picture_test
