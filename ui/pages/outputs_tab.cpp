#include "ui/pages/outputs_tab.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

#include "core/project/stated_requirements.h"
#include "ui/forms/cell_delegate.h"
#include "ui/forms/flow_layout.h"
#include "ui/forms/form_labels.h"
#include "ui/forms/requirement_dialog.h"
#include "ui/models/roles.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/unit_button.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

OutputsTab::OutputsTab(Document& document, Selection& selection, UnitButton& units, QSpinBox& digits,
                       QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), units_(units) {
    make_table();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_filter(digits));
    column->addWidget(table_, 1);
}

void OutputsTab::set_result(const ResultPointer& result, bool current) {
    result_ = result;
    current_ = current;
    model_.set_group(to_std(shown_group()));
    take_requirements();
}

void OutputsTab::take_units() {
    model_.set_units(units_.units());
}

void OutputsTab::take_group() {
    model_.set_group(to_std(shown_group()));
}

void OutputsTab::select_output(std::size_t output) {
    table_->select_row(model_.row_of(output));
}

QWidget* OutputsTab::make_filter(QSpinBox& digits) {
    auto* bar = new QWidget;
    auto* parts = new FlowLayout(bar);  // large letters put units and digits below the filter
    parts->setContentsMargins(4, 2, 4, 2);
    const auto add_part = [parts] {
        auto* part = new QWidget;
        auto* row = new QHBoxLayout(part);
        row->setContentsMargins(0, 0, 0, 0);
        parts->addWidget(part);
        return row;
    };
    QHBoxLayout* row = add_part();
    filter_ = new QLineEdit;
    filter_->setObjectName(QStringLiteral("result_filter"));
    filter_->setPlaceholderText(tr("Filter: symbol, name, group"));
    filter_->setAccessibleName(tr("Filter of the results"));
    filter_->setClearButtonEnabled(true);
    keep_placeholder(*filter_);
    filter_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    auto* require = new QPushButton(tr("Require…"));
    require->setObjectName(QStringLiteral("require"));
    require->setToolTip(tr("Target uncertainty and limits of the results that are selected"));
    all_groups_ = new QCheckBox(tr("All groups"));
    all_groups_->setToolTip(tr("Results of all poses, points or targets, whichever is selected"));
    only_not_met_ = new QCheckBox(tr("Not met only"));
    only_not_met_->setToolTip(tr("Only results whose target uncertainty or tolerance is not met"));
    row->addWidget(filter_);
    row = add_part();
    row->addWidget(all_groups_);
    row->addWidget(only_not_met_);
    row->addWidget(require);
    row = add_part();
    row->addWidget(&units_);
    row->addWidget(&digits);
    connect(require, &QPushButton::clicked, this, &OutputsTab::require_of_selected);
    connect(filter_, &QLineEdit::textChanged, this, &OutputsTab::take_filter);
    connect(only_not_met_, &QCheckBox::toggled, this, &OutputsTab::take_filter);
    connect(all_groups_, &QCheckBox::toggled, this, [this](bool on) {
        table_->set_column_shown(0, on);  // the group
        emit shown_group_changed();
    });
    return bar;
}

void OutputsTab::take_filter() {
    model_.set_filter(filter_->text(), only_not_met_->isChecked());
    table_->select_row(model_.row_of(std::size_t(std::max(0, selection_.output()))));
}

QString OutputsTab::shown_group() const {
    return all_groups_->isChecked() ? QString() : selection_.group();
}

/// Verdicts are of the requirements as they are now.
void OutputsTab::take_requirements() {
    const AnalysisEntry* entry = document_.project().find_analysis(to_std(selection_.analysis()));
    std::vector<RequirementResult> verdicts;
    if (result_ && entry) verdicts = judge(*result_, *entry);
    only_not_met_->setEnabled(!verdicts.empty() || only_not_met_->isChecked());
    const QModelIndex cell = table_->currentIndex();
    model_.requirements().follow(document_, to_std(selection_.analysis()));
    model_.set_result(result_, current_, std::move(verdicts));
    // The first requirement brings columns, and the cell that it was typed into stays the current one.
    if (cell.isValid() && !table_->currentIndex().isValid())
        table_->setCurrentIndex(table_->model()->index(cell.row(), cell.column()));
}

std::vector<std::size_t> OutputsTab::selected_outputs() const {
    std::vector<std::size_t> outputs;
    for (const QModelIndex& cell : table_->selectionModel()->selectedRows())
        outputs.push_back(cell.data(index_role).toULongLong());
    return outputs;
}

void OutputsTab::require_of_selected() {
    std::vector<OutputQuantity> outputs;
    for (const std::size_t output : selected_outputs()) outputs.push_back(result_->outputs[output].quantity);
    ask_what_is_required(document_, to_std(selection_.analysis()), outputs, units_.units(), this);
}

void OutputsTab::make_table() {
    table_ = new SortableTable(model_, tr("results"));
    table_->setObjectName(QStringLiteral("results_table"));
    table_->set_columns(QStringLiteral("results"),
                        {QStringLiteral("Group"), QStringLiteral("Estimate (first order)"),
                         QStringLiteral("U (first order)")});
    table_->extend_menu = [this](QMenu& menu, int row) {
        menu.addAction(tr("Require…"), this, &OutputsTab::require_of_selected);
        const std::size_t output = model_.output_of(row);
        units_.add_choices(*menu.addMenu(tr("Unit")), result_->outputs[output].quantity.unit);
        QAction* shortest = menu.addAction(tr("Shortest Coverage Intervals"));
        shortest->setCheckable(true);
        shortest->setChecked(shortest_);
        connect(shortest, &QAction::toggled, this, [this](bool on) {
            shortest_ = on;
            model_.set_interval(on ? ResultTableModel::Interval::shortest
                                   : ResultTableModel::Interval::symmetric);
        });
    };
    connect(table_, &SortableTable::row_selected, this,
            [this](int row) { selection_.select_output(int(model_.output_of(row))); });
    table_->setItemDelegate(new CellDelegate(table_));
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    auto* clear = new QAction(table_);
    clear->setShortcut(QKeySequence::Delete);
    clear->setShortcutContext(Qt::WidgetShortcut);
    table_->addAction(clear);
    connect(clear, &QAction::triggered, this,
            [this] { table_->model()->setData(table_->currentIndex(), QString()); });
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { model_.requirements().set_typed_together(selected_outputs()); });
}

}  // namespace covaria::ui
