// A list of choices measures its entries once for all that are added together, however many an analysis has.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyledItemDelegate>

#include "ui/forms/form_labels.h"
#include "ui/forms/whole_text.h"

namespace covaria::ui::narrow_list_test {
namespace {

class CountingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        ++measured;
        return QStyledItemDelegate::sizeHint(option, index);
    }
    mutable int measured = 0;
};

TEST(NarrowList, MeasuresItsEntriesOnce) {
    QComboBox box;
    may_be_narrow(box);
    auto* delegate = new CountingDelegate(&box);
    box.setItemDelegate(delegate);
    constexpr int entries = 1000;
    for (int i = 0; i < entries; ++i) {
        box.addItem(QStringLiteral("an output with a long name %1").arg(i));
        box.setItemData(i, i);
    }
    QCoreApplication::processEvents();
    EXPECT_GE(delegate->measured, 1);
    EXPECT_LE(delegate->measured, 4 * entries);
    EXPECT_GT(box.view()->minimumWidth(), box.sizeHint().width()) << "the list shows them whole";
}

TEST(NarrowList, InABarItIsNarrowIfNeedBe) {
    QComboBox box;
    narrow_if_need_be(box);
    const int before = box.sizeHint().width();
    box.addItem(QStringLiteral("a design with a name that is longer than most panes are wide, really"));
    EXPECT_GT(box.sizeHint().width(), 2 * before) << "its entry is read where there is room";
    QWidget pane;
    auto* row = new QHBoxLayout(&pane);
    row->addWidget(&box);
    EXPECT_LT(pane.minimumSizeHint().width(), before + 100);
    row->removeWidget(&box);
    box.setParent(nullptr);
}

// The frame of a group around it counts: the page does not scroll sideways for a long choice.
TEST(NarrowList, AChoiceIsWholeOnlyAsFarAsItsPageIsWide) {
    QScrollArea area;
    area.setWidgetResizable(true);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    auto* group = new QGroupBox(QStringLiteral("a group"));
    column->addWidget(group);
    auto* box = new QComboBox;
    (new QVBoxLayout(group))->addWidget(box);
    may_be_narrow(*box);
    keep_whole(*box);
    box->addItem(QStringLiteral("a choice whose words would make any form wider than the pane it is in"));
    area.setWidget(page);
    area.resize(320, 200);
    area.show();
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    EXPECT_EQ(area.horizontalScrollBar()->maximum(), 0);
    EXPECT_GT(box->minimumWidth(), 200) << "it has what room there is";
}

}  // namespace
}  // namespace covaria::ui::narrow_list_test
