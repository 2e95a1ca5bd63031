#include "ui/pages/seen_tab.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/views/seen_plots.h"
#include "core/views/seen_table.h"
#include "ui/charts/chart_view.h"
#include "ui/document/setup_address.h"
#include "ui/forms/finish_typing.h"
#include "ui/pages/seen_delegate.h"
#include "ui/pages/side_by_side.h"
#include "ui/pages/sortable_table.h"
#include "ui/theme/document_language.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

SeenTab::SeenTab(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner), selection_(selection) {
    table_ = new SortableTable(model_, tr("seen"));
    table_->setObjectName(QStringLiteral("seen_table"));
    table_->setItemDelegate(new SeenDelegate(table_));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(make_head());
    column->addWidget(one_above_other(table_, make_charts()), 1);
    const auto take = [this](const QString& id) {
        if (id == selection_.analysis()) refresh();
    };
    connect(&runner_, &AnalysisRunner::state_changed, this, take);
    connect(&runner_, &AnalysisRunner::result_changed, this, take);
    connect(&selection_, &Selection::analysis_changed, this, &SeenTab::refresh);
    connect(&document_, &Document::project_changed, this, &SeenTab::show_take_over);
    connect(table_, &SortableTable::row_selected, this, &SeenTab::show_charts);
    connect(table_, &SortableTable::row_activated, this, &SeenTab::go_to_source);
    table_->extend_menu = [this](QMenu& menu, int row) {
        menu.addAction(tr("Go to Source"), this, [this, row] { go_to_source(row); });
    };
}

QWidget* SeenTab::make_head() {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(16, 6, 12, 6);
    summary_ = new QLabel;
    summary_->setWordWrap(true);
    summary_->setAccessibleName(tr("What the residuals say"));
    level_ = new QComboBox;
    level_->setObjectName(QStringLiteral("seen_level"));
    level_->setAccessibleName(tr("Level of the tests"));
    level_->setToolTip(tr("How often a figure that is right is contradicted by chance"));
    for (const double level : {0.05, 0.01, 0.001})
        level_->addItem(tr("Level %1 %").arg(QLocale().toString(100 * level)), level);
    take_over_ = new QPushButton;
    take_over_->setObjectName(QStringLiteral("take_over_seen"));
    row->addWidget(summary_, 1);
    row->addWidget(level_, 0, Qt::AlignTop);
    row->addWidget(take_over_, 0, Qt::AlignTop);
    connect(level_, &QComboBox::currentIndexChanged, this, &SeenTab::start);
    connect(take_over_, &QPushButton::clicked, this, &SeenTab::take_over);
    return head;
}

QWidget* SeenTab::make_charts() {
    residuals_ = new ChartView;
    quantiles_ = new ChartView;
    const auto chosen = [this](const char* name, const QString& accessible) {
        auto* box = new QComboBox;
        box->setObjectName(QLatin1String(name));
        box->setAccessibleName(accessible);
        connect(box, &QComboBox::currentIndexChanged, this, &SeenTab::show_charts);
        return box;
    };
    const auto above = [](QComboBox* box, ChartView* chart) {
        auto* part = new QWidget;
        auto* column = new QVBoxLayout(part);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(box, 0, Qt::AlignRight);
        column->addWidget(chart, 1);
        return part;
    };
    abscissa_ = chosen("seen_abscissa", tr("What the residuals are drawn over"));
    shape_ = chosen("seen_shape", tr("Distribution of the residuals"));
    shape_->addItems({tr("Quantiles"), tr("Histogram")});
    return side_by_side(above(abscissa_, residuals_), above(shape_, quantiles_), 3, 2);
}

void SeenTab::show_abscissas() {
    const QSignalBlocker quiet(abscissa_);
    const QString before = abscissa_->currentText();
    abscissa_->clear();
    if (!readings_) return;
    for (const Message& name : residual_abscissas(*readings_))
        abscissa_->addItem(tr("Over: %1").arg(to_qt(language_of_window().say(name))));
    abscissa_->setCurrentIndex(std::max(0, abscissa_->findText(before)));
}

double SeenTab::level() const {
    return level_->currentData().toDouble();
}

void SeenTab::refresh() {
    const auto prepared = runner_.status(selection_.analysis()).prepared;
    // The tab stays where it is while the analysis has a problem.
    if (!prepared || !prepared->model) return;
    if (prepared == prepared_) return;
    // A finding of another analysis is not taken over while that of this one is awaited.
    if (prepared_ && prepared_->id != prepared->id) take_over_->setEnabled(false);
    prepared_ = prepared;
    start();
}

void SeenTab::start() {
    if (!prepared_) return;
    const auto see = [this, prepared = prepared_,
                      level = level()](const std::stop_token&) -> JobQueue::Delivery {
        Found found{prepared->model->redundant_readings(), nullptr};
        if (found.readings)
            found.seen = std::make_shared<const evidence::Seen>(evidence::see(*found.readings, level));
        return [this, found = std::move(found)] { show_seen(found); };
    };
    job_.start(see, [this](const Error& error) { summary_->setText(to_qt(error.message)); });
}

void SeenTab::show_seen(Found found) {
    readings_ = std::move(found.readings);
    seen_ = std::move(found.seen);
    emit filled(readings_ != nullptr);
    model_.set_seen(readings_, seen_);
    show_abscissas();
    QStringList said;
    if (readings_ && seen_)
        for (const Message& note : seen_notes(*readings_, *seen_))
            said += to_qt(language_of_window().say(note));
    summary_->setText(said.join(QLatin1Char(' ')));
    if (table_->current_row() < 0) table_->select_row(0);
    show_take_over();
    show_charts();
}

void SeenTab::go_to_source(int row) {
    const auto number = static_cast<std::size_t>(row);
    if (!readings_ || number >= readings_->figures.size()) return;
    const std::string& source = readings_->figures[number].source;
    const SetupAddress own{SetupOwner::analysis, to_std(selection_.analysis())};
    if (!source.empty()) emit place_wanted(to_qt(setup_path(document_.project(), own) + source));
}

void SeenTab::show_charts() {
    const bool any = readings_ && seen_ && !seen_->figures.empty();
    const auto figure = static_cast<std::size_t>(std::max(0, table_->current_row()));
    const DocumentLanguage language = language_of_window();
    const auto over = static_cast<std::size_t>(std::max(0, abscissa_->currentIndex()));
    const auto distribution = shape_->currentIndex() == 0 ? quantile_plot : residual_histogram;
    residuals_->set_plot(any ? residual_plot(*readings_, figure, over, language) : PlotSpecification());
    quantiles_->set_plot(any ? distribution(*readings_, figure, language) : PlotSpecification());
}

bool SeenTab::is_taken_over() const {
    const Setup* setup =
        find_setup(document_.project(), {SetupOwner::analysis, to_std(selection_.analysis())});
    if (!setup || !readings_) return false;
    const auto value = setup->values.find(readings_->take_over.field);
    const auto* chosen = value == setup->values.end() ? nullptr : std::get_if<std::string>(&value->second);
    return chosen && *chosen != readings_->take_over.as_stated;
}

void SeenTab::show_take_over() {
    take_over_->setVisible(readings_ && !readings_->take_over.field.empty());
    const bool taken = is_taken_over();
    take_over_->setText(taken ? tr("Back to Stated") : tr("Take Over as Seen"));
    take_over_->setToolTip(
        taken ? tr("The results follow from the stated uncertainties again")
              : tr("The results, and all that hang on them, follow from the uncertainties that the residuals "
                   "see, and change with the readings; can be undone"));
    take_over_->setEnabled(taken || (seen_ && std::ranges::any_of(seen_->figures, evidence::is_known)));
}

void SeenTab::take_over() {
    finish_typing();
    if (!readings_ || readings_->take_over.field.empty()) return;
    const evidence::TakeOver& choice = readings_->take_over;
    const bool taken = is_taken_over();
    const SetupAddress address{SetupOwner::analysis, to_std(selection_.analysis())};
    document_.apply(taken ? tr("Back to stated uncertainties") : tr("Take over uncertainties as seen"),
                    [&](Project& project) {
                        if (Setup* setup = find_setup(project, address))
                            setup->values[choice.field] = taken ? choice.as_stated : choice.as_seen;
                    });
}

}  // namespace covaria::ui
