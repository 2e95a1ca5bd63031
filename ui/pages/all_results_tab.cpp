#include "ui/pages/all_results_tab.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>

#include "core/project/stated_requirements.h"
#include "ui/forms/form_labels.h"
#include "ui/pages/sortable_table.h"
#include "ui/run/result_words.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

AllResultsTab::AllResultsTab(Document& document, AnalysisRunner& runner, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner) {
    filter_ = new QLineEdit;
    filter_->setPlaceholderText(tr("Filter: analysis, symbol, name, group"));
    filter_->setAccessibleName(tr("Filter of all results"));
    filter_->setClearButtonEnabled(true);
    keep_placeholder(*filter_);
    filter_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    only_not_met_ = new QCheckBox(tr("Not met only"));
    only_not_met_->setToolTip(tr("Only results whose target uncertainty or tolerance is not met"));
    count_ = new QLabel;
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 4, 2);
    bar->setSpacing(8);
    bar->addWidget(filter_);
    bar->addWidget(only_not_met_);
    bar->addWidget(count_, 1);
    table_ = new SortableTable(model_, tr("all-results"));
    table_->set_columns(QStringLiteral("all_results"),
                        {QStringLiteral("Output quantity"), QStringLiteral("k")});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(table_, 1);
    const auto take_filter = [this] { model_.set_filter(filter_->text(), only_not_met_->isChecked()); };
    connect(filter_, &QLineEdit::textChanged, this, take_filter);
    connect(only_not_met_, &QCheckBox::toggled, this, take_filter);
    for (auto signal : {&AnalysisRunner::state_changed, &AnalysisRunner::result_changed})
        connect(&runner_, signal, this, &AllResultsTab::refresh);
    connect(&document_, &Document::project_changed, this, &AllResultsTab::refresh);
    connect(table_, &SortableTable::row_activated, this, [this](int row) {
        const AllResultsModel::Place place = model_.place_of(row);
        emit result_wanted(to_qt(place.analysis), to_qt(place.group), int(place.output));
    });
}

void AllResultsTab::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

/// Fills the table anew, but only while it is looked at.
void AllResultsTab::refresh() {
    if (!isVisible()) return;
    std::vector<ShownAnalysis> shown;
    for (const AnalysisEntry& analysis : document_.project().analyses) {
        const AnalysisStatus& status = runner_.status(to_qt(analysis.id));
        if (!status.result) continue;
        const QString said = reservation(status);
        shown.push_back({analysis.id, analysis.name, status.result, status.is_of_present(),
                         said.isEmpty() ? tr("up to date") : said, judge(*status.result, analysis)});
    }
    count_->setText(count_words(shown));
    only_not_met_->setEnabled(only_not_met_->isChecked() ||
                              std::any_of(shown.begin(), shown.end(), [](const ShownAnalysis& analysis) {
                                  return !analysis.verdicts.empty();
                              }));
    model_.set_analyses(std::move(shown));
}

QString AllResultsTab::count_words(const std::vector<ShownAnalysis>& analyses) const {
    std::size_t all = 0, met = 0;
    for (const ShownAnalysis& analysis : analyses)
        for (const RequirementResult& verdict : analysis.verdicts) {
            ++all;
            if (is_met(verdict)) ++met;
        }
    QStringList words;
    if (all > 0) words << tr("%1 of %2 requirements met").arg(met).arg(all);
    const std::vector<AnalysisEntry>& entries = document_.project().analyses;
    const std::size_t without = entries.size() - analyses.size();
    const bool some_can_run = std::any_of(entries.begin(), entries.end(), [this](const AnalysisEntry& entry) {
        const AnalysisStatus& status = runner_.status(to_qt(entry.id));
        return !status.result && status.prepared;
    });
    if (without > 0)
        words << (some_can_run ? tr("%1 of %2 analyses have no result: press Ctrl+F5")
                               : tr("%1 of %2 analyses have no result: they lack something or have problems"))
                     .arg(without)
                     .arg(entries.size());
    return words.join(tr("; "));
}

}  // namespace covaria::ui
