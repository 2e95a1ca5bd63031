// A list of choices measures its entries once for all that are added together, however many an analysis has.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QStyledItemDelegate>

#include "ui/forms/form_labels.h"

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

}  // namespace
}  // namespace covaria::ui::narrow_list_test
