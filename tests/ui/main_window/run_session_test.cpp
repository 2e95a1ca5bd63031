// Running: stopping a long run with the window responsive, and results known as out of date.
#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/export_actions.h"
#include "ui/pages/current_results.h"

namespace covaria::ui::run_session_test {
namespace {

using RunSession = Session;

/// The longest time during which the event loop did not turn.
class LoopWatch {
public:
    LoopWatch() {
        clock_.start();
        QObject::connect(&tick_, &QTimer::timeout, &tick_, [this] {
            const qint64 now = clock_.nsecsElapsed();
            longest_ = std::max(longest_, now - last_);
            last_ = now;
            ++ticks_;
        });
        tick_.start(1);
    }
    double longest_ms() const { return double(longest_) * 1e-6; }
    int ticks() const { return ticks_; }

private:
    QTimer tick_;
    QElapsedTimer clock_;
    qint64 last_ = 0, longest_ = 0;
    int ticks_ = 0;
};

bool says(const QWidget& pane, const QString& words) {
    for (const QLabel* label : pane.findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(words, Qt::CaseInsensitive)) return true;
    return false;
}

TEST_F(RunSession, ALongRunIsStoppedAndTheWindowStaysResponsive) {
    open(project_copy());
    wait_until_idle();
    show_group(QStringLiteral("Options"));
    type_into("trials", QStringLiteral("100000000"));
    ASSERT_TRUE(wait_for(
        [this] { return status().state == RunState::running && status().stage == ResultStage::preview; }));
    {
        const LoopWatch watch;
        QSignalSpy progress(&window_->runner(), &AnalysisRunner::progress_changed);
        ASSERT_TRUE(wait_for([&] { return progress.size() >= 5; })) << "the run goes on";
        EXPECT_GT(watch.ticks(), 10) << "the event loop turns";
        RecordProperty("longest_pause_ms", std::to_string(watch.longest_ms()));
        std::cout << "longest pause of the event loop during the run: " << watch.longest_ms() << " ms\n";
    }
    ASSERT_EQ(status().state, RunState::running);
    trigger(QStringLiteral("Stop"));
    ASSERT_TRUE(window_->runner().wait_until_idle(10'000));
    EXPECT_EQ(status().state, RunState::out_of_date);
    EXPECT_EQ(status().stage, ResultStage::preview) << "what there was is still shown";
    EXPECT_TRUE(answer_.messages.isEmpty()) << "stopping is not a failure";
    trigger(QStringLiteral("Run This Analysis"));
    EXPECT_TRUE(wait_for([this] { return status().state == RunState::running; })) << "it can be run again";
    trigger(QStringLiteral("Stop"));
    ASSERT_TRUE(window_->runner().wait_until_idle(10'000));
}

TEST_F(RunSession, ResultsAreMarkedOutOfDateWhileLiveIsOff) {
    open(project_copy());
    wait_until_idle();
    EXPECT_FALSE(says(*window_, QStringLiteral("out of date")));
    trigger(QStringLiteral("Live"));
    const double before = expanded_uncertainty(2);
    type_into("base_u_z", QStringLiteral("1.05 mm"));
    ASSERT_TRUE(wait_for([this] { return !window_->runner().is_busy() && !status().is_current(); }));
    EXPECT_EQ(status().state, RunState::out_of_date);
    EXPECT_EQ(expanded_uncertainty(2), before);
    EXPECT_TRUE(says(*window_, QStringLiteral("out of date")));
    EXPECT_EQ(answer_.messages.size(), 0);
    answer_.file_to_save = folder_.filePath(QStringLiteral("report.pdf"));
    QSignalSpy exported(&window_->exports(), &ExportActions::finished);
    trigger(QStringLiteral("Report as PDF"));
    ASSERT_TRUE(wait_for([&] { return exported.size() == 1; }, 120'000)) << "of the other analysis";
    const auto reported = current_results(window_->document().project(), window_->runner());
    for (const EvaluatedAnalysis& one : reported)
        EXPECT_NE(one.analysis->id, to_std(window_->selection().analysis())) << "what is stale stays here";
    trigger(QStringLiteral("Run This Analysis"));
    wait_until_idle();
    EXPECT_EQ(status().state, RunState::up_to_date);
    EXPECT_GT(expanded_uncertainty(2), 2.0 * before);
    EXPECT_FALSE(says(*window_, QStringLiteral("out of date")));
}

}  // namespace
}  // namespace covaria::ui::run_session_test
