// Parts that the style draws by itself.
#include "ui/theme/style.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyleOptionViewItem>

#include "tests/ui/qt_application.h"
#include "ui/theme/theme.h"

namespace covaria::ui::style_test {
namespace {

constexpr int side = 17;

/// The check box of a cell in a row that is selected or not.
QImage check_box(bool ticked, bool selected) {
    const QPalette palette = QApplication::palette("QTableView");  // a selected row is tinted
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(selected ? tokens_of(palette).tint : palette.color(QPalette::Base));
    QStyleOptionViewItem option;
    option.palette = palette;
    option.rect = image.rect();
    option.state = QStyle::State_Enabled | (ticked ? QStyle::State_On : QStyle::State_Off);
    if (selected) option.state |= QStyle::State_Selected;
    QPainter painter(&image);
    QApplication::style()->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &option, &painter);
    return image;
}

TEST(Style, ACheckBoxThatIsNotTickedIsEmptyInASelectedRowToo) {
    for (const Theme& theme : {Theme::dark(), Theme::light()}) {
        apply_theme(*qApp, theme);
        for (const bool selected : {false, true}) {
            const QColor ground =
                selected ? theme.tokens().tint : QApplication::palette("QTableView").color(QPalette::Base);
            const QImage empty = check_box(false, selected);
            EXPECT_EQ(empty.pixelColor(side / 2, side / 2), ground) << theme.is_dark() << selected;
            EXPECT_GE(contrast(empty.pixelColor(side / 2, 0), ground), 2.0) << "its outline is seen";
            EXPECT_NE(check_box(true, selected), empty);
        }
    }
}

}  // namespace
}  // namespace covaria::ui::style_test
