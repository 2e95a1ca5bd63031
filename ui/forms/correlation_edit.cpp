// A matrix, a list of components to add, and the verdict.
#include "ui/forms/correlation_edit.h"

#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/forms/cell_delegate.h"
#include "ui/forms/complaint.h"
#include "ui/forms/flow_layout.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_views.h"

namespace covaria::ui {

CorrelationEdit::CorrelationEdit(Document& document, QWidget* parent)
    : QWidget(parent),
      model_(new InputCorrelationModel(document, this)),
      view_(new QTableView(this)),
      components_(new QComboBox(this)),
      add_(new QPushButton(tr("Add to the matrix"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      state_(new QLabel(this)) {
    view_->setHorizontalHeader(new TypesetHeader(Qt::Horizontal, view_));
    view_->setVerticalHeader(new TypesetHeader(Qt::Vertical, view_));
    view_->setModel(model_);
    view_->setItemDelegate(new CellDelegate(view_));
    view_->setAccessibleName(tr("Correlation coefficients between components of uncertainty"));
    components_->setAccessibleName(tr("Component of uncertainty"));
    components_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    components_->setMinimumContentsLength(16);
    keep_room(*state_, 4);
    auto* row = new FlowLayout;
    row->addWidget(add_);
    row->addWidget(remove_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(components_);
    layout->addLayout(row);
    layout->addWidget(view_, 1);
    layout->addWidget(state_);
    connect(add_, &QPushButton::clicked, this, [this] {
        if (components_->currentIndex() >= 0) model_->add_component(to_std(components_->currentText()));
    });
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (view_->currentIndex().isValid()) model_->remove_component(view_->currentIndex().row());
    });
    connect(model_, &QAbstractItemModel::modelReset, this, &CorrelationEdit::refresh_choices);
    connect(model_, &InputCorrelationModel::complaint_changed, this, &CorrelationEdit::refresh_state);
    refresh_choices();
}

void CorrelationEdit::set_analysis(std::shared_ptr<const PreparedAnalysis> analysis) {
    model_->set_analysis(std::move(analysis));
    refresh_choices();
}

void CorrelationEdit::focus_pair(const std::string& first, const std::string& second) {
    if (const QModelIndex cell = model_->index_of(first, second); cell.isValid())
        view_->setCurrentIndex(cell);
    view_->setFocus(Qt::OtherFocusReason);
}

void CorrelationEdit::refresh_choices() {
    const QString chosen = components_->currentText();
    components_->clear();
    for (const std::string& id : model_->other_components()) components_->addItem(to_qt(id));
    components_->setCurrentIndex(std::max(0, components_->findText(chosen)));
    add_->setEnabled(components_->count() > 0);
    remove_->setEnabled(model_->rowCount() > 0);
    refresh_state();
}

void CorrelationEdit::refresh_state() {
    const QString& complaint = model_->complaint();
    if (!complaint.isEmpty())
        state_->setText(complaint);
    else if (model_->rowCount() == 0)
        state_->setText(tr("All components are uncorrelated. Add those that are correlated to the matrix."));
    else
        state_->setText(
            tr("The coefficients are possible together (positive semi-definite). Monte Carlo draws them with "
               "a Gaussian copula: exact for normal distributions, nearly so for others."));
    mark(*view_, complaint, {});
}

}  // namespace covaria::ui
