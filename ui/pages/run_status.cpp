#include "ui/pages/run_status.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

#include "core/text/numbers.h"
#include "ui/models/number_words.h"
#include "ui/models/problems_model.h"
#include "ui/models/project_tree_model.h"
#include "ui/pages/entry_delegate.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

QString time_left_words(double seconds) {
    constexpr double minute = 60.0, hour = 3600.0, most_seconds = 90.0;
    if (seconds < most_seconds) return RunStatus::tr("%1 s left").arg(std::ceil(seconds));
    if (seconds < hour) return RunStatus::tr("%1 min left").arg(std::ceil(seconds / minute));
    return RunStatus::tr("%1 h left").arg(QLocale().toString(seconds / hour, 'f', 1));
}

QString progress_words(const RunProgress& progress) {
    QString words = RunStatus::tr("%1 trials").arg(to_qt(count_text(progress.trials_done)));
    if (progress.trials_per_second > 0)
        words +=
            RunStatus::tr(", %1 million/s").arg(QLocale().toString(progress.trials_per_second / 1e6, 'f', 2));
    if (progress.seconds_left >= 0) words += QStringLiteral(", ") + time_left_words(progress.seconds_left);
    return words;
}

RunStatus::RunStatus(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner), selection_(selection) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 4, 0);
    picture_ = new QLabel(this);
    text_ = new QLabel(this);
    bar_ = new QProgressBar(this);
    bar_->setFixedWidth(160);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("Progress of the run"));
    stop_ = new QToolButton(this);
    stop_->setIcon(icon(QStringLiteral("stop")));
    stop_->setAutoRaise(true);
    stop_->setToolTip(tr("Stop all runs (Esc)"));
    stop_->setAccessibleName(tr("Stop all runs"));
    for (QWidget* widget : std::initializer_list<QWidget*>{bar_, stop_, picture_, text_})
        row->addWidget(widget);
    follow_font(*this, [this] {
        bar_->setFixedHeight(fontMetrics().height());
        // The height is kept between runs, too: the scene would move while it is dragged.
        setMinimumHeight(stop_->sizeHint().height());
    });
    connect(stop_, &QToolButton::clicked, &runner_, &AnalysisRunner::stop_all);
    connect(&runner_, &AnalysisRunner::progress_changed, this, &RunStatus::show_progress);
    connect(&runner_.kept(), &KeptStates::progress_changed, this,
            [this](const QString& id, const RunProgress& progress) {
                show_bar(tr("%1, kept state: ").arg(name_of(id)) + progress_words(progress), progress);
            });
    connect(&runner_, &AnalysisRunner::state_changed, this, &RunStatus::show_state);
    connect(&runner_, &AnalysisRunner::idle, this, &RunStatus::show_idle);
    for (InquiryRunner* inquiries :
         std::initializer_list<InquiryRunner*>{&runner_.studies(), &runner_.designs()}) {
        connect(inquiries, &InquiryRunner::progress_changed, this, &RunStatus::show_inquiry_progress);
        connect(inquiries, &InquiryRunner::idle, this, &RunStatus::show_idle);
    }
    connect(&selection_, &Selection::analysis_changed, this, &RunStatus::show_state);
    connect(&document_, &Document::project_changed, this, &RunStatus::show_state);
    connect(&document_, &Document::problems_changed, this, &RunStatus::show_state);
    show_idle();
}

QString RunStatus::words() const {
    return text_->text();
}

QString RunStatus::name_of(const QString& id) const {
    const AnalysisEntry* analysis = document_.project().find_analysis(to_std(id));
    return analysis ? to_qt(analysis->name) : id;
}

void RunStatus::set_picture(const QString& name) {
    const int size = fontMetrics().height();
    picture_->setPixmap(name.isEmpty() ? QPixmap()
                                       : icon(name).pixmap(QSize(size, size), devicePixelRatioF()));
}

void RunStatus::show_progress(const QString& id, const RunProgress& progress) {
    show_bar(name_of(id) + QStringLiteral(": ") + progress_words(progress), progress);
}

void RunStatus::show_inquiry_progress(const QString& name, const RunProgress& progress) {
    QString words = tr("%1: %2 %")
                        .arg(name)
                        .arg(progress.trials_planned > 0
                                 ? int(100.0 * double(progress.trials_done) / double(progress.trials_planned))
                                 : 0);
    if (progress.best)
        words += tr(", best so far %1").arg(localized(format_significant(*progress.best, 5)));
    else if (progress.seconds_left >= 0)
        words += QStringLiteral(", ") + time_left_words(progress.seconds_left);
    show_bar(words, progress);
}

void RunStatus::show_bar(const QString& words, const RunProgress& progress) {
    running_ = true;
    set_picture(state_icon(RunState::running));
    text_->setText(words);
    bar_->setRange(0, progress.trials_planned > 0 ? 1000 : 0);
    if (progress.trials_planned > 0)
        bar_->setValue(int(1000.0 * double(progress.trials_done) / double(progress.trials_planned)));
    bar_->show();
    stop_->show();
}

void RunStatus::show_state() {
    if (running_) return;
    const QString& id = selection_.analysis();
    const AnalysisEntry* analysis = document_.project().find_analysis(to_std(id));
    if (!analysis) {
        set_picture({});
        if (document_.project().title.empty())
            text_->clear();  // the start page
        else
            text_->setText(document_.project().analyses.empty() ? tr("No analysis yet")
                                                                : tr("No analysis selected"));
        return;
    }
    const AnalysisStatus& status = runner_.status(id);
    QString words = ProjectTreeModel::words(status.state);
    if (status.state == RunState::incomplete)
        if (const QString missing = ProblemsModel::missing_words(document_, analysis->id); !missing.isEmpty())
            words += QStringLiteral(": ") + missing;
    const bool said = status.state == RunState::failed || status.state == RunState::incomplete;
    if (!status.prepared && !said) words = tr("has problems");
    if (status.state == RunState::up_to_date && status.result && status.result->trials > 0)
        words += tr(", %1 trials").arg(to_qt(count_text(status.result->trials)));
    const bool warned = status.state == RunState::up_to_date && !status.warnings.empty();
    if (warned) words += tr(", with warnings");
    const QString verdict = ProjectTreeModel::verdict_words(*analysis, status);
    if (!verdict.isEmpty()) words += QStringLiteral(", ") + verdict;
    set_picture(!verdict.isEmpty() ? QStringLiteral("state-not-met")
                : warned           ? QStringLiteral("warning")
                                   : state_icon(status.state));
    text_->setText(name_of(id) + QStringLiteral(": ") + words);
}

void RunStatus::show_idle() {
    if (runner_.is_busy() || runner_.studies().is_busy() || runner_.designs().is_busy()) return;
    running_ = false;
    bar_->hide();
    stop_->hide();
    show_state();
}

}  // namespace covaria::ui
