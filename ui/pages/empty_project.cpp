#include "ui/pages/empty_project.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/model/model_descriptor.h"
#include "ui/pages/project_pane.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

EmptyProject::EmptyProject(QWidget* parent)
    : QWidget(parent), models_(new QTreeView(this)), rows_(new QStandardItemModel(0, 2, this)) {
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
    models_->setAccessibleName(tr("What is to be evaluated?"));
    models_->setModel(rows_);
    models_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    models_->setHeaderHidden(true);
    models_->setRootIsDecorated(false);
    models_->setAllColumnsShowFocus(true);
    models_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    fill();
    setFocusProxy(models_);
    connect(library, &QPushButton::clicked, this, &EmptyProject::library_wanted);
    const auto choose = [this](const QModelIndex& cell) {
        if (isVisible())  // a click may activate, too
            emit analysis_wanted(to_std(cell.data(Qt::UserRole).toString()));
    };
    connect(models_, &QTreeView::clicked, this, choose);
    connect(models_, &QTreeView::activated, this, choose);
}

void EmptyProject::fill() {
    constexpr int around = 10;
    for (const ModelDescriptor* model : models_for_new_analyses()) {
        QList<QStandardItem*> row;
        for (const std::string& text : {model->title, model->summary}) {
            row << new QStandardItem(core_text(text));
            row.back()->setSizeHint({fontMetrics().horizontalAdvance(row.back()->text()) + around,
                                     fontMetrics().height() + around});
            row.back()->setData(to_qt(model->id), Qt::UserRole);
            row.back()->setToolTip(core_text(model->summary));
        }
        rows_->appendRow(row);
    }
    models_->setCurrentIndex(rows_->index(0, 0));
}

}  // namespace covaria::ui
