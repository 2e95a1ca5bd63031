#include "ui/main_window/run_actions.h"

#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "ui/forms/finish_typing.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {
const QString live_key = QStringLiteral("live");
}

RunActions::RunActions(Document& document, AnalysisRunner& runner, Selection& selection, QObject* parent)
    : QObject(parent),
      run(new QAction(icon(QStringLiteral("run")), tr("&Run This Analysis"), this)),
      run_all(new QAction(icon(QStringLiteral("run-all")), tr("Run &All"), this)),
      stop(new QAction(icon(QStringLiteral("stop")), tr("&Stop"), this)),
      live(new QAction(icon(QStringLiteral("live")), tr("&Live"), this)),
      document_(document),
      runner_(runner),
      selection_(selection) {
    run->setShortcut(Qt::Key_F5);
    run_all->setShortcut(Qt::CTRL | Qt::Key_F5);
    stop->setShortcut(Qt::Key_Escape);
    live->setCheckable(true);
    live->setStatusTip(tr("Each edit computes first-order results at once, then Monte Carlo"));
    connect(run, &QAction::triggered, this, [this] {
        finish_typing();
        runner_.run(selection_.analysis());
    });
    connect(run_all, &QAction::triggered, this, [this] {
        finish_typing();
        runner_.run_all();
    });
    connect(stop, &QAction::triggered, &runner_, &AnalysisRunner::stop_all);
    connect(live, &QAction::toggled, this, [this](bool on) {
        runner_.set_live(on);
        QSettings().setValue(live_key, on);
    });
    live->setChecked(QSettings().value(live_key, true).toBool());
    for (auto signal : {&AnalysisRunner::state_changed, &AnalysisRunner::result_changed})
        connect(&runner_, signal, this, &RunActions::update);
    connect(&runner_, &AnalysisRunner::idle, this, &RunActions::update);
    for (const InquiryRunner* inquiries :
         std::initializer_list<const InquiryRunner*>{&runner_.studies(), &runner_.designs()}) {
        connect(inquiries, &InquiryRunner::changed, this, &RunActions::update);
        connect(inquiries, &InquiryRunner::idle, this, &RunActions::update);
    }
    connect(&selection_, &Selection::analysis_changed, this, &RunActions::update);
    connect(&document_, &Document::project_changed, this, &RunActions::update);
    update();
}

void RunActions::add_to(QMenu& menu) {
    menu.addActions({run, run_all, stop});
    menu.addSeparator();
    menu.addAction(live);
}

void RunActions::update() {
    const auto& analyses = document_.project().analyses;
    run->setEnabled(document_.project().find_analysis(to_std(selection_.analysis())) != nullptr);
    run_all->setEnabled(!analyses.empty());
    stop->setEnabled(std::any_of(analyses.begin(), analyses.end(),
                                 [this](const AnalysisEntry& analysis) {
                                     return runner_.status(to_qt(analysis.id)).state == RunState::running;
                                 }) ||
                     runner_.studies().is_busy() || runner_.designs().is_busy() || runner_.kept().is_busy());
}

}  // namespace covaria::ui
