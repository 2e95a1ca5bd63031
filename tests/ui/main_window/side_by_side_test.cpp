// Tables that share their room with a chart or with what is said of a row.
#include "ui/pages/side_by_side.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QScrollBar>
#include <QTableWidget>
#include <QTest>
#include <memory>

#include "tests/ui/qt_application.h"

namespace covaria::ui::side_by_side_test {
namespace {

QTableWidget* table_of(int rows, int row_height, int column_width) {
    auto* table = new QTableWidget(rows, 1);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table->verticalHeader()->setMinimumSectionSize(4);
    table->verticalHeader()->setDefaultSectionSize(row_height);
    table->setColumnWidth(0, column_width);
    return table;
}

bool scrolls(const QAbstractScrollArea& view) {
    return view.horizontalScrollBar()->maximum() > 0 || view.verticalScrollBar()->maximum() > 0;
}

TEST(SideBySide, ATableOfEitherSideTakesTheRoomThatItNeeds) {
    for (const bool at_the_right : {false, true}) {
        QTableWidget* table = table_of(3, 20, 560);
        auto* chart = new QWidget;
        std::unique_ptr<QSplitter> splitter(at_the_right ? side_by_side(chart, table)
                                                         : side_by_side(table, chart));
        widen_to_content(*splitter, *table);
        splitter->resize(1000, 400);
        splitter->show();
        QTest::qWait(50);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !scrolls(*table); }, 3000)) << at_the_right;
        EXPECT_GE(table->width(), 560) << at_the_right;
        EXPECT_GE(chart->width(), 320);
        EXPECT_LT(table->width(), 660) << "no more than it needs";
    }
}

TEST(SideBySide, ATableAboveIsAsHighAsItsRowsWhereHalfWillDo) {
    QTableWidget* table = table_of(12, 20, 100);
    auto* details = new QWidget;
    std::unique_ptr<QSplitter> splitter(one_above_other(table, details, 1, 3));
    widen_to_content(*splitter, *table);
    splitter->resize(400, 800);
    splitter->show();
    QTest::qWait(50);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !scrolls(*table); }, 3000));
    table->setRowCount(100);
    QTest::qWait(50);
    EXPECT_TRUE(scrolls(*table));
    EXPECT_GE(details->height(), 390) << "the other half";
}

}  // namespace
}  // namespace covaria::ui::side_by_side_test
