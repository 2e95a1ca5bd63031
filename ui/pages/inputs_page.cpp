#include "ui/pages/inputs_page.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <cstdio>
#include <string_view>

#include "ui/forms/components_edit.h"
#include "ui/forms/correlation_edit.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset.h"

namespace covaria::ui {

InputsPage::InputsPage(Document& document, AnalysisRunner& runner, std::string analysis, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      analysis_(std::move(analysis)),
      model_(document) {
    search_ = new QLineEdit;
    search_->setPlaceholderText(tr("Find a quantity"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(tr("Find a quantity"));
    make_table();
    components_ = new ComponentsEdit(document_);
    correlations_ = new CorrelationEdit(document_);
    auto* details = details_ = new QTabWidget;
    details->setDocumentMode(true);
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(components_);
    details->addTab(scroll, tr("Components"));
    details->addTab(correlations_, tr("Correlations"));
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(table_);
    splitter->addWidget(details);
    splitter->setSizes({1000, 1300});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addWidget(search_);
    column->addWidget(splitter, 1);
    connect(search_, &QLineEdit::textChanged, &filter_, &QSortFilterProxyModel::setFilterFixedString);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &InputsPage::show_components);
    connect(&runner_, &AnalysisRunner::state_changed, this, [this](const QString& id) {
        if (to_std(id) == analysis_) take_analysis();
    });
    take_analysis();
}

void InputsPage::make_table() {
    filter_.setSourceModel(&model_);
    filter_.setFilterCaseSensitivity(Qt::CaseInsensitive);
    filter_.setFilterKeyColumn(-1);
    filter_.setSortRole(sort_role);
    table_ = new QTableView;
    table_->setHorizontalHeader(new TypesetHeader(Qt::Horizontal, table_));
    table_->setItemDelegate(new TypesetDelegate(table_));
    table_->setModel(&filter_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setAccessibleName(tr("Input quantities"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setAlternatingRowColors(true);
    table_->setWordWrap(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->hideColumn(InputQuantitiesModel::name_column);
}

void InputsPage::take_analysis() {
    const auto& prepared = runner_.status(to_qt(analysis_)).prepared;
    if (prepared == model_.analysis()) return;
    model_.set_analysis(prepared);
    correlations_->set_analysis(prepared);
    if (!table_->currentIndex().isValid() && model_.rowCount() > 0) table_->selectRow(0);
    show_components();
}

void InputsPage::show_components() {
    const QString symbol = table_->currentIndex().data(id_role).toString();
    components_->set_quantity(model_.analysis(), to_std(symbol));
}

bool InputsPage::focus_field(const std::string& path) {
    const AnalysisEntry* analysis = document_.project().find_analysis(analysis_);
    if (!analysis) return false;
    const std::string entry = entry_path(document_.project(), {SetupOwner::analysis, analysis_});
    if (path.starts_with(entry + "/correlations")) {
        details_->setCurrentWidget(correlations_);
        correlations_->view().setFocus(Qt::OtherFocusReason);
        return true;
    }
    if (!path.starts_with(entry + "/inputs/")) return false;
    // An edit by its number, or a quantity by its symbol.
    const std::string rest = path.substr(entry.size() + std::string_view("/inputs/").size());
    std::string symbol = rest.substr(0, rest.find('/'));
    unsigned index = 0;
    if (std::sscanf(rest.c_str(), "%u", &index) == 1 && index < analysis->inputs.size())
        symbol = analysis->inputs[index].symbol;
    const int row = model_.row_of(symbol);
    if (row < 0) return false;
    details_->setCurrentIndex(0);
    search_->clear();
    table_->selectRow(filter_.mapFromSource(model_.index(row, 0)).row());
    return true;
}

}  // namespace covaria::ui
