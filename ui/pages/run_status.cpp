#include "ui/pages/run_status.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

namespace covaria::ui {

QString progress_words(const RunProgress& progress) {
    QString words = RunStatus::tr("%1 trials").arg(QLocale().toString(qulonglong(progress.trials_done)));
    if (progress.trials_per_second > 0)
        words +=
            RunStatus::tr(", %1 million/s").arg(QLocale().toString(progress.trials_per_second / 1e6, 'f', 2));
    if (progress.seconds_left >= 0)
        words += RunStatus::tr(", %1 s left").arg(std::ceil(progress.seconds_left));
    return words;
}

RunStatus::RunStatus(AnalysisRunner& runner, QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    text_ = new QLabel(this);
    bar_ = new QProgressBar(this);
    bar_->setFixedWidth(160);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress of the run"));
    stop_ = new QToolButton(this);
    stop_->setText(tr("Stop"));
    stop_->setToolTip(tr("Stop all runs (Esc)"));
    row->addWidget(text_);
    row->addWidget(bar_);
    row->addWidget(stop_);
    connect(stop_, &QToolButton::clicked, &runner, &AnalysisRunner::stop_all);
    connect(&runner, &AnalysisRunner::progress_changed, this, &RunStatus::show_progress);
    connect(&runner, &AnalysisRunner::idle, this, &RunStatus::show_idle);
    show_idle();
}

void RunStatus::show_progress(const QString& id, const RunProgress& progress) {
    text_->setText(id + QStringLiteral(": ") + progress_words(progress));
    bar_->setRange(0, progress.trials_planned > 0 ? 1000 : 0);
    if (progress.trials_planned > 0)
        bar_->setValue(int(1000.0 * double(progress.trials_done) / double(progress.trials_planned)));
    bar_->show();
    stop_->show();
}

void RunStatus::show_idle() {
    text_->clear();
    bar_->hide();
    stop_->hide();
}

}  // namespace covaria::ui
