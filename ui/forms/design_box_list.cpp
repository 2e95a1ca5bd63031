#include "ui/forms/design_box_list.h"

#include <QGridLayout>
#include <QLabel>

#include "ui/document/quantity_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

DesignBoxList::DesignBoxList(const QString& title, const QString& key, const QString& help, QWidget* parent)
    : QGroupBox(title, parent), key_(key) {
    setToolTip(help);
    column_ = new QVBoxLayout(this);
    auto* add = new QPushButton(tr("Add Box"));
    add->setObjectName(key_ + QStringLiteral("_add"));
    add->setToolTip(help);
    column_->addWidget(add, 0, Qt::AlignLeft);
    connect(add, &QPushButton::clicked, this, [this] {
        emit edited(
            [](std::vector<DesignBox>& boxes) {
                DesignBox box;
                box.to = {1000.0, 1000.0, 1000.0};
                boxes.push_back(box);
            },
            {});
    });
}

void DesignBoxList::change(std::size_t number, const std::function<void(DesignBox&)>& how,
                           const QString& field) {
    emit edited(
        [number, how](std::vector<DesignBox>& boxes) {
            if (number < boxes.size()) how(boxes[number]);
        },
        QStringLiteral("%1-%2-%3").arg(key_).arg(number).arg(field));
}

/// A box has one unit: the other numbers follow into that of the one just typed.
QuantityEdit* DesignBoxList::coordinate(std::size_t number, std::size_t axis, bool upper) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    auto* edit = new QuantityEdit;
    const QString field = QStringLiteral("%1_%2").arg(upper ? QStringLiteral("to") : QStringLiteral("from"),
                                                      QLatin1String(axes[axis]));
    edit->setObjectName(QStringLiteral("%1_%2_%3").arg(key_).arg(number).arg(field));
    edit->setAccessibleName((upper ? tr("To, %1") : tr("From, %1")).arg(QString::fromLatin1(axes[axis])));
    edit->set_optional(false);
    connect(edit, &QuantityEdit::quantity_edited, this,
            [this, number, axis, upper, field](const std::optional<Quantity>& quantity) {
                if (!quantity) return;
                change(
                    number,
                    [axis, upper, typed = *quantity](DesignBox& box) {
                        for (auto* corner : {&box.from, &box.to})
                            for (double& value : *corner) value = converted(value, box.unit, typed.unit);
                        box.unit = typed.unit;
                        (upper ? box.to : box.from)[axis] = typed.value;
                    },
                    field);
            });
    return edit;
}

void DesignBoxList::add_row() {
    const std::size_t number = rows_.size();
    Row row;
    row.whole = new QWidget;
    auto* grid = new QGridLayout(row.whole);
    grid->setContentsMargins(0, 0, 0, 6);
    row.name = new QLineEdit;
    row.name->setObjectName(QStringLiteral("%1_%2_name").arg(key_).arg(number));
    row.name->setAccessibleName(tr("Name of the box"));
    row.name->setPlaceholderText(tr("name, such as pillar"));
    auto* remove = new QPushButton(tr("Remove Box"));
    remove->setObjectName(QStringLiteral("%1_%2_remove").arg(key_).arg(number));
    grid->addWidget(row.name, 0, 0, 1, 3);
    grid->addWidget(remove, 0, 3);
    grid->addWidget(new QLabel(tr("From")), 1, 0);
    grid->addWidget(new QLabel(tr("To")), 2, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        row.from[axis] = coordinate(number, axis, false);
        row.to[axis] = coordinate(number, axis, true);
        grid->addWidget(row.from[axis], 1, int(axis) + 1);
        grid->addWidget(row.to[axis], 2, int(axis) + 1);
    }
    connect(row.name, &QLineEdit::editingFinished, this, [this, number, name = row.name] {
        change(
            number, [text = to_std(name->text())](DesignBox& box) { box.name = text; },
            QStringLiteral("name"));
    });
    connect(remove, &QPushButton::clicked, this, [this, number] {
        emit edited(
            [number](std::vector<DesignBox>& boxes) {
                if (number < boxes.size()) boxes.erase(boxes.begin() + std::ptrdiff_t(number));
            },
            {});
    });
    column_->insertWidget(int(number), row.whole);
    rows_.push_back(row);
}

void DesignBoxList::show_boxes(const std::vector<DesignBox>& boxes, UnreadTexts& unread,
                               const TextPlace& place) {
    static constexpr const char* ends[] = {"/from/", "/to/"};
    while (rows_.size() < boxes.size()) add_row();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        const std::string here = place.part + "/" + std::to_string(i);
        row.whole->setVisible(i < boxes.size());
        if (i >= boxes.size()) {
            unread.replace_under(place.entry, here + "/", {});
            continue;
        }
        const DesignBox& box = boxes[i];
        if (!row.name->hasFocus() || row.name->text() != to_qt(box.name)) row.name->setText(to_qt(box.name));
        for (std::size_t end = 0; end < 2; ++end)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                QuantityEdit* edit = end == 0 ? row.from[axis] : row.to[axis];
                edit->set_unit(box.unit);
                edit->set_place(unread, {place.entry, here + ends[end] + std::to_string(axis)});
                edit->set_quantity(Quantity{end == 0 ? box.from[axis] : box.to[axis], box.unit});
            }
    }
}

}  // namespace covaria::ui
