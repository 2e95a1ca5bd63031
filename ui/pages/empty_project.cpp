#include "ui/pages/empty_project.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/model/model_descriptor.h"
#include "ui/pages/project_pane.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

EmptyProject::EmptyProject(QWidget* parent) : QWidget(parent), models_(new QTreeWidget(this)) {
    setAccessibleName(tr("Empty project"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    auto* head = new QHBoxLayout;
    auto* title = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("What is to be evaluated?").toHtmlEscaped()));
    title->setWordWrap(true);
    auto* library = new QPushButton(icon(QStringLiteral("layers")), tr("&Library and Templates …"));
    head->addWidget(title, 1);
    head->addWidget(library);
    column->addLayout(head);
    column->addWidget(models_, 1);
    models_->setObjectName(QStringLiteral("models"));
    models_->setAccessibleName(title->text());
    models_->setColumnCount(2);
    models_->setHeaderHidden(true);
    models_->setRootIsDecorated(false);
    models_->setAllColumnsShowFocus(true);
    models_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    fill();
    setFocusProxy(models_);
    connect(library, &QPushButton::clicked, this, &EmptyProject::library_wanted);
    const auto choose = [this](const QTreeWidgetItem* item) {
        emit analysis_wanted(to_std(item->data(0, Qt::UserRole).toString()));
    };
    connect(models_, &QTreeWidget::itemClicked, this, choose);
    connect(models_, &QTreeWidget::itemActivated, this, choose);
}

void EmptyProject::fill() {
    for (const ModelDescriptor* model : models_for_new_analyses()) {
        auto* item = new QTreeWidgetItem(models_, {core_text(model->title), core_text(model->summary)});
        item->setData(0, Qt::UserRole, to_qt(model->id));
        for (int i = 0; i < 2; ++i) item->setToolTip(i, item->text(1));
    }
    models_->setCurrentItem(models_->topLevelItem(0));
}

}  // namespace covaria::ui
