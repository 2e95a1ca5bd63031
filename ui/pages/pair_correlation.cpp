#include "ui/pages/pair_correlation.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>
#include <array>

#include "core/text/symbol.h"
#include "ui/forms/budget_sheet_view.h"
#include "ui/forms/complaint.h"
#include "ui/models/roles.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

PairCorrelation::PairCorrelation(Document& document, QWidget* parent)
    : QWidget(parent), correlations_(document), pair_(new QLabel), field_(new QLineEdit) {
    pair_->setTextFormat(Qt::RichText);
    field_->setObjectName(QStringLiteral("correlation"));
    field_->setAccessibleName(tr("Correlation coefficient"));
    follow_font(*field_,
                [this] { field_->setFixedWidth(8 * field_->fontMetrics().averageCharWidth() + 12); });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(pair_);
    row->addWidget(field_);
    field_->installEventFilter(this);
    connect(field_, &QLineEdit::editingFinished, this, &PairCorrelation::take);
    connect(&correlations_, &QAbstractItemModel::modelReset, this, &PairCorrelation::show_pair);
}

void PairCorrelation::follow(BudgetSheetModel* sheet, BudgetSheetView* view) {
    sheet_ = sheet;
    view_ = view;
    if (view_)
        connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
                &PairCorrelation::show_pair);
}

void PairCorrelation::set_analysis(const PreparedPointer& analysis) {
    if (analysis != correlations_.analysis()) correlations_.set_analysis(analysis);
    show_pair();
}

std::set<int> PairCorrelation::selected_rows() const {
    std::set<int> rows;
    for (const QModelIndex& cell : view_->selectionModel()->selectedIndexes()) rows.insert(cell.row());
    return rows;
}

/// Selects the text of the coefficient on focus, so that typing replaces it, also after a click.
bool PairCorrelation::eventFilter(QObject* watched, QEvent* event) {
    if (watched == field_ && event->type() == QEvent::FocusIn)
        QMetaObject::invokeMethod(field_, &QLineEdit::selectAll, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

QModelIndex PairCorrelation::selected_pair() {
    if (!view_ || !correlations_.analysis()) return {};
    const std::set<int> rows = selected_rows();
    if (rows.size() != 2) return {};
    std::array<int, 2> at{};
    auto place = at.begin();
    for (const int row : rows) {
        const std::string id = sheet_->component_of(row);
        if (id.empty()) return {};
        const auto find = [&] {
            for (int i = 0; i < correlations_.rowCount(); ++i)
                if (to_std(correlations_.headerData(i, Qt::Vertical).toString()) == id) return i;
            return -1;
        };
        if (find() < 0) {
            const QSignalBlocker quiet(correlations_);  // nobody else looks at it
            correlations_.add_component(id);
        }
        *place++ = find();
    }
    return correlations_.index(at[0], at[1]);
}

void PairCorrelation::show_pair() {
    if (field_->hasFocus()) return;
    const QModelIndex cell = selected_pair();
    for (QWidget* widget : {static_cast<QWidget*>(pair_), static_cast<QWidget*>(field_)})
        widget->setEnabled(cell.isValid());
    const auto symbol = [this](int row) { return to_qt(to_html(symbol_text(sheet_->symbol_of(row)))); };
    pair_->setText(cell.isValid()
                       ? tr("<i>r</i>(%1, %2) =")
                             .arg(symbol(*selected_rows().begin()), symbol(*selected_rows().rbegin()))
                       : tr("<i>r</i> of two rows ="));
    field_->setText(cell.isValid() ? cell.data(Qt::EditRole).toString() : QString());
    mark_field(cell);
}

void PairCorrelation::mark_field(const QModelIndex& cell) {
    const bool lack = !cell.isValid() && view_ && selected_rows().size() == 2;
    mark(*field_, cell.data(problem_role).toString(),
         lack ? tr("Both quantities need an uncertainty before they can be correlated")
              : tr("Select two rows, and type the correlation coefficient of their components"));
}

void PairCorrelation::take() {
    const QModelIndex cell = selected_pair();
    if (cell.isValid() && field_->text() != cell.data(Qt::EditRole).toString())
        correlations_.setData(cell, field_->text());
    mark_field(cell);
}

void PairCorrelation::ask() {
    if (field_->isEnabled())
        field_->setFocus();
    else
        QToolTip::showText(field_->mapToGlobal(QPoint(0, field_->height())), field_->toolTip(), field_);
}

}  // namespace covaria::ui
