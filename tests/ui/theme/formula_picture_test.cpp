// Formulas as pictures: where their letters stand.
#include "ui/theme/formula_picture.h"

#include <gtest/gtest.h>

#include <QFont>

#include "core/text/symbol.h"

namespace covaria::ui::formula_picture_test {
namespace {

Text repeated(const Text& of, int times) {
    Text all;
    for (int i = 0; i < times; ++i) all += of + Text(" + ");
    return all;
}

// A subscript hangs on its own letter, however many came before it on the line.
TEST(FormulaPicture, SubscriptsOfALineStandAtOneHeight) {
    const QFont font;
    const Text symbol = symbol_text("a_1");
    const FormulaPicture once(repeated(symbol, 1), font), often(repeated(symbol, 6), font);
    EXPECT_DOUBLE_EQ(often.height(), once.height());
    EXPECT_NEAR(often.width(), 6.0 * once.width(), 1e-6);
}

}  // namespace
}  // namespace covaria::ui::formula_picture_test
