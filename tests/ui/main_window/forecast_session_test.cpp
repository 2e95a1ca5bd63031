// The adaptive procedure in the window: how many trials it needs is said before it runs.
#include <QLabel>
#include <QTest>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/theme/strings.h"

namespace covaria::ui::forecast_session_test {
namespace {

class ForecastSession : public Session {
protected:
    void choose(const Quantity& tolerance) {
        window_->document().apply(QStringLiteral("Choose"), [&](Project& project) {
            EvaluationOptions& options = project.analyses.front().options;
            options.method = Method::adaptive;
            options.tolerance = tolerance;
            options.maximum_trials = 20'000;  // a short run
        });
    }
    QString forecast() const {
        const auto* label = window_->properties().findChild<QLabel*>(QStringLiteral("forecast"));
        return label ? label->text() : QString();
    }
};

TEST_F(ForecastSession, SaysHowManyTrialsATolerancesNeeds) {
    open(project_copy());
    window_->selection().select_entry(
        {SetupOwner::analysis, window_->document().project().analyses.front().id});
    EXPECT_TRUE(forecast().isEmpty()) << "a fixed number of trials needs no forecast";
    choose({0.001, Unit::of("mm")});
    EXPECT_TRUE(QTest::qWaitFor([&] { return forecast().contains(QStringLiteral("0.001 mm")); }, 30'000))
        << forecast().toStdString();
    EXPECT_TRUE(forecast().contains(QStringLiteral("trials")));
    choose({0.002, Unit::of("mm")});
    EXPECT_TRUE(QTest::qWaitFor([&] { return forecast().contains(QStringLiteral("0.002 mm")); }, 30'000))
        << forecast().toStdString();
}

}  // namespace
}  // namespace covaria::ui::forecast_session_test
