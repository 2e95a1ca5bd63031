// Formulas set as mathematics: sizes that follow from their parts, ink where it belongs.
#include "ui/theme/formula_picture.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>

namespace covaria::ui::formula_picture_test {
namespace {

using K = Formula::Kind;

const Formula x = Formula::of_symbol({"x", "", ""}), y = Formula::of_symbol({"y", "", ""}),
              two = Formula::leaf(K::number, "2"), plus = Formula::leaf(K::sign, "+");

Formula of(K kind, std::vector<Formula> parts) {
    Formula f = Formula::row(std::move(parts));
    f.kind = kind;
    return f;
}

FormulaPicture picture(const Formula& formula) {
    return FormulaPicture(formula, QFont(QApplication::font().family(), 20));
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
    const FormulaPicture a = picture(x), line = picture(of(K::row, {x, y}));
    const FormulaPicture fraction = picture(of(K::fraction, {x, y}));
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
    const FormulaPicture plain = picture(of(K::row, {x, two}));
    const FormulaPicture power = picture(of(K::power, {x, two}));
    const FormulaPicture index = picture(Formula::of_symbol({"x", "2", ""}));
    EXPECT_LT(power.width(), plain.width());
    EXPECT_GT(power.baseline(), plain.baseline());
    EXPECT_GT(index.height() - index.baseline(), plain.height() - plain.baseline());
}

TEST(FormulaPicture, ARootCoversWhatIsUnderIt) {
    const FormulaPicture inside = picture(of(K::row, {x, plus, y}));
    const FormulaPicture root = picture(of(K::root, {of(K::row, {x, plus, y})}));
    EXPECT_GT(root.width(), inside.width());
    EXPECT_GT(root.baseline(), inside.baseline());
}

TEST(FormulaPicture, ParenthesesGrowWithWhatTheyHold) {
    Formula low = Formula::leaf(K::fence, "("), high = low;
    low.parts = {x};
    high.parts = {of(K::fraction, {x, y})};
    const int left = 16;
    const auto ink = [&](const FormulaPicture& f) { return dark_pixels(f, QRect(0, 0, left, 200)); };
    EXPECT_GT(ink(picture(high)), 1.3 * ink(picture(low)));
}

TEST(FormulaPicture, ASymbolMayHaveBothScripts) {
    const FormulaPicture both = picture(Formula::of_symbol({"x", "1", "2"}));
    const FormulaPicture below = picture(Formula::of_symbol({"x", "1", ""}));
    EXPECT_GT(both.baseline(), below.baseline());
    EXPECT_NEAR(both.width(), below.width(), 3.0) << "one above the other";
}

TEST(FormulaPicture, TextIsSetWithItsScripts) {
    const QFont font(QApplication::font().family(), 20);
    const FormulaPicture prose(equation_text("o_p = R"), font), plain(Text("o_p = R"), font);
    EXPECT_LT(prose.width(), plain.width());
    EXPECT_GT(prose.height() - prose.baseline(), plain.height() - plain.baseline());
    EXPECT_TRUE(FormulaPicture(Text(), font).is_empty());
}

}  // namespace
}  // namespace covaria::ui::formula_picture_test
