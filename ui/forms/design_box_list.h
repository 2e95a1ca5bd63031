// The boxes of a design, no instrument in them or no line of sight through them: name, corners, add, remove.
#pragma once

#include <QGroupBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <functional>
#include <vector>

#include "core/project/design.h"
#include "ui/forms/quantity_edit.h"

namespace covaria::ui {

class DesignBoxList : public QGroupBox {
    Q_OBJECT
public:
    using Edit = std::function<void(std::vector<DesignBox>&)>;
    /// `key`: beginning of the names of its fields, "keep_out".
    DesignBoxList(const QString& title, const QString& key, const QString& help, QWidget* parent = nullptr);

    /// `place` of the list in the project: "/designs/0/keepOut".
    void show_boxes(const std::vector<DesignBox>& boxes, UnreadTexts& unread, const TextPlace& place);

signals:
    void edited(const covaria::ui::DesignBoxList::Edit& edit, const QString& field);

private:
    struct Row {
        QWidget* whole = nullptr;
        QLineEdit* name = nullptr;
        std::array<QuantityEdit*, 3> from{}, to{};
    };
    void add_row();
    QuantityEdit* coordinate(std::size_t number, std::size_t axis, bool upper);
    void change(std::size_t number, const std::function<void(DesignBox&)>& how, const QString& field);

    QString key_;
    QVBoxLayout* column_ = nullptr;
    std::vector<Row> rows_;
};

}  // namespace covaria::ui
