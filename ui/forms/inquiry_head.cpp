#include "ui/forms/inquiry_head.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/forms/finish_typing.h"
#include "ui/forms/flow_layout.h"
#include "ui/forms/form_labels.h"

namespace covaria::ui {

InquiryHead::InquiryHead(const Words& words, QWidget* parent)
    : QWidget(parent), list_(new QComboBox), hint_(new QLabel(words.hint)) {
    const auto button = [&words](const QString& text, const char* name, const QString& tip) {
        auto* made = new QPushButton(text);
        made->setObjectName(QString::fromLatin1(name) + words.object);
        made->setToolTip(tip);
        return made;
    };
    list_->setObjectName(words.list);
    list_->setAccessibleName(words.title);
    may_be_narrow(*list_);
    add_ = button(tr("Add"), "add_", words.add);
    duplicate_ = button(tr("Duplicate"), "duplicate_", words.duplicate);
    remove_ = button(tr("Delete"), "remove_", words.remove);
    run_ = button(tr("Run"), "run_", words.run);
    hint_->setWordWrap(true);
    hint_->setEnabled(false);
    auto* row = new FlowLayout;
    for (QPushButton* each : {add_, duplicate_, remove_, run_}) row->addWidget(each);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(list_);
    column->addLayout(row);
    column->addWidget(hint_);
    connect(list_, &QComboBox::activated, this,
            [this](int index) { emit chosen(list_->itemData(index).toString()); });
    connect(add_, &QPushButton::clicked, this, &InquiryHead::add_wanted);
    connect(duplicate_, &QPushButton::clicked, this, &InquiryHead::duplicate_wanted);
    connect(remove_, &QPushButton::clicked, this, &InquiryHead::remove_wanted);
    connect(run_, &QPushButton::clicked, this, [this] {
        finish_typing();
        emit run_wanted();
    });
}

void InquiryHead::show_list(const QList<std::pair<QString, QString>>& items, const QString& selected) {
    const QSignalBlocker blocker(list_);
    list_->clear();
    for (const auto& [id, name] : items) list_->addItem(name, id);
    list_->setCurrentIndex(list_->findData(selected));
    list_->setVisible(!items.isEmpty());
    const bool any = list_->currentIndex() >= 0;
    hint_->setVisible(!any);
    for (QPushButton* each : {duplicate_, remove_, run_}) each->setEnabled(any);
}

}  // namespace covaria::ui
