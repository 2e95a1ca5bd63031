// Typing quantities with real keys.
#include "ui/forms/quantity_edit.h"

#include <gtest/gtest.h>

#include "tests/ui/qt_application.h"
#include "ui/forms/complaint.h"

namespace covaria::ui::quantity_edit_test {
namespace {

struct QuantityEditTest : testing::Test {
    QuantityEditTest() {
        edit.set_unit(Unit::of("mm"));
        edit.set_quantity(Quantity{2.0, Unit::of("mm")});
        QObject::connect(&edit, &QuantityEdit::quantity_edited, &edit, [this](const auto& quantity) {
            last = quantity;
            ++count;
        });
    }
    void type(const QString& text) {
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        QTest::keyClick(&edit, Qt::Key_Return);
    }
    QuantityEdit edit;
    std::optional<Quantity> last;
    int count = 0;
};

TEST_F(QuantityEditTest, KeepsTheUnitTyped) {
    EXPECT_EQ(edit.text(), "2 mm");
    type("0.5 um");
    EXPECT_EQ(last, (Quantity{0.5, Unit::of("um")}));
    EXPECT_EQ(edit.text(), QString::fromUtf8("0.5 µm"));
    type("0.7");
    EXPECT_EQ(last, (Quantity{0.7, Unit::of("um")})) << "the unit that is shown stays";
}

TEST_F(QuantityEditTest, ConvertsWhereTheUnitIsFixed) {
    edit.set_keeps_unit(false);
    type("500 um");
    EXPECT_EQ(last, (Quantity{0.5, Unit::of("mm")}));
}

TEST_F(QuantityEditTest, ReadsTheLocalesDecimalMark) {
    edit.setLocale(QLocale(QLocale::German, QLocale::Germany));
    type("1,5");
    EXPECT_EQ(last, (Quantity{1.5, Unit::of("mm")}));
    EXPECT_EQ(edit.text(), "1,5 mm");
}

TEST_F(QuantityEditTest, InvalidTextIsMarkedAndNotLost) {
    edit.set_help("How long it is.");
    type("5 kg");
    EXPECT_EQ(count, 0);
    EXPECT_EQ(edit.text(), "5 kg");
    EXPECT_FALSE(edit.is_valid());
    EXPECT_FALSE(complaint_of(edit).isEmpty());
    EXPECT_EQ(edit.toolTip(), complaint_of(edit));
    edit.set_quantity(Quantity{2.0, Unit::of("mm")});
    EXPECT_EQ(edit.text(), "5 kg") << "an unrelated change of the project leaves it";
    type("5 cm");
    EXPECT_TRUE(edit.is_valid());
    EXPECT_EQ(edit.toolTip(), "How long it is.");
    EXPECT_EQ(count, 1);
}

TEST_F(QuantityEditTest, ChecksRangeAndPresence) {
    edit.set_range({0.0, 1.0, true});
    type("0");
    EXPECT_EQ(count, 0);
    type("2 m");
    EXPECT_EQ(count, 0);
    EXPECT_TRUE(complaint_of(edit).contains("1 m")) << complaint_of(edit).toStdString();
    edit.set_optional(false);
    edit.selectAll();
    QTest::keyClick(&edit, Qt::Key_Delete);
    QTest::keyClick(&edit, Qt::Key_Return);
    EXPECT_EQ(count, 0);
    EXPECT_FALSE(edit.is_valid());
}

TEST_F(QuantityEditTest, AnEmptyOptionalLineIsNoQuantity) {
    edit.selectAll();
    QTest::keyClick(&edit, Qt::Key_Delete);
    QTest::keyClick(&edit, Qt::Key_Return);
    EXPECT_EQ(count, 1);
    EXPECT_FALSE(last);
}

TEST_F(QuantityEditTest, ArrowKeysStepTheLastDigit) {
    type("0.25");
    QTest::keyClick(&edit, Qt::Key_Up);
    EXPECT_EQ(last, (Quantity{0.26, Unit::of("mm")}));
    QTest::keyClick(&edit, Qt::Key_Down);
    QTest::keyClick(&edit, Qt::Key_Down);
    EXPECT_EQ(last, (Quantity{0.24, Unit::of("mm")}));
}

TEST_F(QuantityEditTest, EscapeGivesTheOldTextBack) {
    edit.selectAll();
    QTest::keyClicks(&edit, "9");
    QTest::keyClick(&edit, Qt::Key_Escape);
    EXPECT_EQ(edit.text(), "2 mm");
    type("2");
    EXPECT_EQ(count, 0) << "the same quantity is no edit";
}

TEST_F(QuantityEditTest, ProblemsFromOutsideAreShownUntilTheyAreGone) {
    edit.set_complaint("collides with the base");
    EXPECT_EQ(complaint_of(edit), "collides with the base");
    edit.set_complaint({});
    EXPECT_TRUE(complaint_of(edit).isEmpty());
}

}  // namespace
}  // namespace covaria::ui::quantity_edit_test
