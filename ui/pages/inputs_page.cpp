#include "ui/pages/inputs_page.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdio>
#include <string_view>

#include "core/project/links.h"
#include "ui/document/correlated_pair.h"
#include "ui/document/quantity_edits.h"
#include "ui/forms/components_edit.h"
#include "ui/forms/correlation_edit.h"
#include "ui/forms/link_dialog.h"
#include "ui/forms/quantity_notes_edit.h"
#include "ui/models/roles.h"
#include "ui/pages/evaluation_view.h"
#include "ui/theme/core_text.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/quiet_table.h"
#include "ui/theme/strings.h"
#include "ui/theme/typeset_views.h"

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
    observations_ = new EvaluationView(Qt::Vertical);
    correlations_ = new CorrelationEdit(document_);
    notes_ = new QuantityNotesEdit(document_, analysis_);
    details_ = new FoldGroups;
    details_->add(components_, tr("Components"), true);
    details_->add(observations_, tr("Observations"), true);
    details_->add(correlations_, tr("Correlations"));
    details_->add(notes_, tr("Notes on the quantity"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* above = new QVBoxLayout;
    above->setContentsMargins(16, 2, 16, 8);
    auto* note =
        new QLabel(tr("The quantities that the set-up makes. What is changed here replaces what the "
                      "set-up states."));
    note->setWordWrap(true);
    note->setEnabled(false);
    above->addWidget(note);
    above->addWidget(search_);
    column->addLayout(above);
    column->addWidget(table_);
    column->addWidget(details_);
    connect(search_, &QLineEdit::textChanged, &filter_, &QSortFilterProxyModel::setFilterFixedString);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &InputsPage::show_quantity);
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
    table_->setItemDelegateForColumn(InputQuantitiesModel::components_column,
                                     new TypesetDelegate(table_, Qt::ElideRight));
    table_->setModel(&filter_);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);
    table_->setAccessibleName(tr("Input quantities"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setWordWrap(false);
    table_->verticalHeader()->hide();
    make_quiet(*table_, RowRoom::inspector);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(InputQuantitiesModel::components_column,
                                                     QHeaderView::Interactive);
    table_->viewport()->installEventFilter(this);
    connect(&filter_, &QAbstractItemModel::modelReset, this, &InputsPage::fit_components);
    connect(&filter_, &QAbstractItemModel::modelReset, this, &InputsPage::fit_height);
    // The others fit their contents in their own time.
    connect(table_->horizontalHeader(), &QHeaderView::sectionResized, this, [this](int column) {
        if (column != InputQuantitiesModel::components_column) fit_components();
    });
    table_->hideColumn(InputQuantitiesModel::name_column);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this, &InputsPage::show_menu);
}

/// Gives the column of components the room that the others leave; less than its head: they stand below only.
void InputsPage::fit_components() {
    QHeaderView& head = *table_->horizontalHeader();
    constexpr int column = InputQuantitiesModel::components_column;
    int room = table_->viewport()->width();
    for (int other = 0; other < head.count(); ++other)
        if (other != column) room -= head.sectionSize(other);
    head.showSection(column);  // a hidden one is not measured
    const int least = head.sectionSizeHint(column);
    head.setSectionHidden(column, room < least);
    if (room >= least) head.resizeSection(column, room);
}

/// Makes the table as high as its quantities if they are few; more are scrolled.
void InputsPage::fit_height() {
    constexpr int fewest = 3, most = 10;
    const int rows = std::clamp(model_.rowCount(), fewest, most);
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           rows * table_->verticalHeader()->defaultSectionSize() + 2);
}

bool InputsPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == table_->viewport() && event->type() == QEvent::Resize) fit_components();
    return QWidget::eventFilter(watched, event);
}

void InputsPage::take_analysis() {
    const auto& prepared = runner_.status(to_qt(analysis_)).prepared;
    if (prepared == model_.analysis()) return;
    model_.set_analysis(prepared);
    correlations_->set_analysis(prepared);
    if (!table_->currentIndex().isValid() && model_.rowCount() > 0) table_->selectRow(0);
    show_quantity();
}

void InputsPage::show_quantity() {
    const QString symbol = table_->currentIndex().data(id_role).toString();
    components_->set_quantity(model_.analysis(), to_std(symbol));
    const int row = model_.row_of(to_std(symbol));
    components_->setEnabled(row >= 0 && !model_.is_linked(row));
    notes_->set_quantity(to_std(symbol));
    show_observations(to_std(symbol));
}

/// The tab is there for quantities that were observed.
void InputsPage::show_observations(const std::string& symbol) {
    std::vector<PlotSpecification> charts;
    if (const auto& prepared = model_.analysis())
        for (PlotSpecification& chart : core_plots(prepared->model->figures()))
            if (!symbol.empty() && chart.quantity == symbol) charts.push_back(std::move(chart));
    details_->set_shown(observations, !charts.empty());
    observations_->show_evaluation({}, std::move(charts));
}

std::vector<LinkChoice> InputsPage::link_choices(const std::string& symbol) const {
    std::vector<LinkChoice> choices;
    const int row = model_.row_of(symbol);
    if (row < 0) return choices;
    const auto dimension = model_.quantity(row).unit.dimension();
    const auto takers = analyses_taking_from(document_.project(), analysis_);
    for (const AnalysisEntry& entry : document_.project().analyses) {
        const bool circle =
            entry.id == analysis_ || std::find(takers.begin(), takers.end(), entry.id) != takers.end();
        const auto& prepared = runner_.status(to_qt(entry.id)).prepared;
        if (circle || !prepared) continue;
        LinkChoice choice{entry.id, entry.name.empty() ? entry.id : entry.name, {}};
        for (const OutputQuantity& output : prepared->model->outputs()) {
            if (output.unit.dimension() != dimension) continue;
            choice.outputs.push_back({entry.id, output.group, output.symbol});
            choice.groups.push_back(output.group);
        }
        if (!choice.outputs.empty()) choices.push_back(std::move(choice));
    }
    return choices;
}

void InputsPage::ask_for_link(const std::string& symbol) {
    LinkDialog dialog(symbol, link_choices(symbol), find_link(document_.project(), analysis_, symbol), this);
    if (dialog.exec() != QDialog::Accepted) return;
    if (const auto link = dialog.link()) set_link(document_, analysis_, symbol, link);
}

void InputsPage::show_menu(const QPoint& at) {
    const QModelIndex index = table_->indexAt(at);
    if (!index.isValid()) return;
    const std::string symbol = to_std(index.data(id_role).toString());
    QMenu menu(this);
    menu.addAction(tr("Take From an Analysis …"), this, [this, symbol] { ask_for_link(symbol); });
    QAction* remove = menu.addAction(
        tr("Remove Link"), this, [this, symbol] { set_link(document_, analysis_, symbol, std::nullopt); });
    remove->setEnabled(find_link(document_.project(), analysis_, symbol).has_value());
    menu.exec(table_->viewport()->mapToGlobal(at));
}

bool InputsPage::focus_field(const std::string& path) {
    const AnalysisEntry* analysis = document_.project().find_analysis(analysis_);
    if (!analysis) return false;
    const std::string entry = entry_path(document_.project(), {SetupOwner::analysis, analysis_});
    if (const std::string links = entry + "/links/"; path.starts_with(links)) {
        unsigned number = 0;
        if (std::sscanf(path.c_str() + links.size(), "%u", &number) != 1 || number >= analysis->links.size())
            return false;
        return select_quantity(analysis->links[number].input);
    }
    if (path.starts_with(entry + "/correlations")) {
        details_->open(correlations);
        const auto pair = pair_in(*analysis, path.substr(entry.size())).value_or(CorrelatedPair());
        correlations_->focus_pair(pair.first, pair.second);
        return true;
    }
    if (!path.starts_with(entry + "/inputs/")) return false;
    // An edit by its number, or a quantity by its symbol.
    const std::string rest = path.substr(entry.size() + std::string_view("/inputs/").size());
    std::string symbol = rest.substr(0, rest.find('/'));
    unsigned index = 0;
    if (std::sscanf(rest.c_str(), "%u", &index) == 1 && index < analysis->inputs.size())
        symbol = analysis->inputs[index].symbol;
    return select_quantity(symbol);
}

bool InputsPage::select_quantity(const std::string& symbol) {
    const int row = model_.row_of(symbol);
    if (row < 0) return false;
    details_->open(components);
    show_quantity_of(symbol);
    table_->setFocus(Qt::OtherFocusReason);
    return true;
}

void InputsPage::show_quantity_of(const std::string& symbol) {
    const int row = model_.row_of(symbol);
    if (row < 0) return;
    search_->clear();
    table_->selectRow(filter_.mapFromSource(model_.index(row, 0)).row());
}

}  // namespace covaria::ui
