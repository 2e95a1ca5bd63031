// A row of widgets that goes on in the next line where there is no room.
#pragma once

#include <QLayout>
#include <QList>

namespace covaria::ui {

/// Sets items from the left, each as large as it likes to be; its least width is that of the widest.
class FlowLayout : public QLayout {
public:
    using QLayout::QLayout;
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override { items_ << item; }
    int count() const override { return int(items_.size()); }
    QLayoutItem* itemAt(int index) const override { return items_.value(index); }
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize minimumSize() const override;
    QSize sizeHint() const override;
    void setGeometry(const QRect& rect) override;

private:
    /// The height that is taken in a room of this width.
    int arrange(const QRect& rect, bool move) const;
    int gap() const;

    QList<QLayoutItem*> items_;
};

}  // namespace covaria::ui
