// The strip above the stage: the statement of a certificate, its verdict, and what becomes of it while the
// project changes.
#include <QClipboard>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "core/text/numbers.h"
#include "core/views/result_statement.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/document/project_edits.h"
#include "ui/pages/answer_strip.h"
#include "ui/theme/chip.h"
#include "ui/theme/document_language.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui::answer_session_test {
namespace {

AnalysisEntry& bar_of(Project& project) {
    return *std::ranges::find(project.analyses, "bar", &AnalysisEntry::id);
}

class AnswerSession : public Session {
protected:
    AnswerStrip& answer() const { return window_->results().answer(); }
    std::string value() const { return answer().value().text().letters(); }
    std::string verdict() const {
        return answer().verdict().isHidden() ? "" : answer().verdict().words().letters();
    }
    void open_and_wait(const QString& name) {
        open(project_copy(name));
        wait_until_idle();
        settle();
    }
    void require(const std::string& symbol, const Quantity& target) {
        window_->document().apply(QStringLiteral("Require"), [&](Project& project) {
            Requirement wanted;
            wanted.symbol = symbol;
            wanted.target_uncertainty = target;
            bar_of(project).requirements = {wanted};
        });
        wait_until_idle();
    }
};

TEST_F(AnswerSession, OneOutputIsStatedAsInACertificate) {
    open_and_wait(QStringLiteral("chain"));
    select(SetupOwner::analysis, "bar");
    wait_until_idle();
    ASSERT_TRUE(status().is_current());
    const OutputResult& output = status().result->outputs.front();
    EXPECT_EQ(value(), output.quantity.symbol + " = " + value_statement(output, true, language_of_window()));
    EXPECT_TRUE(answer().coverage().text().letters().starts_with("k = "));
    EXPECT_TRUE(answer().coverage().text().letters().ends_with("p = " + percent_text(0.95)));
    EXPECT_TRUE(answer().state().text().contains(QStringLiteral("20"))) << "how many trials";
    EXPECT_TRUE(answer().outputs().isHidden()) << "nothing to choose from";
    QTest::mouseClick(&answer().copy_button(), Qt::LeftButton);
    EXPECT_EQ(
        to_std(QGuiApplication::clipboard()->text()),
        output.quantity.symbol + " = " + result_statement(output, *status().result, language_of_window()));
}

TEST_F(AnswerSession, AUBelowTheLaboratorysBestCapabilityIsSaid) {
    open_and_wait(QStringLiteral("certificate-gauge-block"));
    EXPECT_FALSE(answer().state().text().contains(QStringLiteral("best capability")));
    SetupTable ranges;
    ranges.units.assign(4, Unit{});
    ranges.rows = {{0.0, 100.0, 0.08, 0.0}};
    window_->document().apply(QStringLiteral("Capability"), [&](Project& project) {
        AssetEntry capability{"cmc", "best-capability", "Gauge blocks", {}, {}};
        capability.setup.values = {{"unit", std::string("um")}, {"ranges", ranges}};
        project.assets.push_back(capability);
    });
    EXPECT_TRUE(wait_for([this] {
        return answer().state().text().contains(QStringLiteral("certificates state 80 nm"));
    })) << to_std(answer().state().text());
    keep_picture(QStringLiteral("answer-capability"));
}

// Between two projects there is none that was made.
TEST_F(AnswerSession, AnotherProjectMayBeOpenedWhileAnAnalysisRuns) {
    open_and_wait(QStringLiteral("chain"));
    select(SetupOwner::analysis, "bar");
    wait_until_idle();
    ASSERT_TRUE(status().result);
    trigger(QStringLiteral("Run This Analysis"));
    open(project_copy(QStringLiteral("certificate-gauge-block")));
    wait_until_idle();
    EXPECT_TRUE(wait_for([this] { return status().is_current(); }));
}

TEST_F(AnswerSession, OfAPoseTheLargestUncertaintyOfEachKindIsTheAnswer) {
    open_and_wait(QStringLiteral("stewart-platform"));
    const UncertaintyResult& result = *status().result;
    double largest = 0.0;
    std::string symbol;
    for (const OutputResult& output : result.outputs)
        if (to_qt(output.quantity.group) == window_->selection().group() &&
            output.quantity.unit.dimension() == Unit::of("mm").dimension() &&
            output.expanded_uncertainty > largest) {
            largest = output.expanded_uncertainty;
            symbol = output.quantity.symbol;
        }
    EXPECT_NE(value().find("U = "), std::string::npos) << value();
    EXPECT_NE(value().find("mm (" + symbol + ")"), std::string::npos) << value();
    EXPECT_NE(value().find("°"), std::string::npos) << value();
    EXPECT_EQ(answer().outputs().count(), 6);
    EXPECT_EQ(answer().statements().split(QLatin1Char('\n')).size(), 6) << "a line each is copied";
}

TEST_F(AnswerSession, TheVerdictFollowsTheRequirement) {
    open_and_wait(QStringLiteral("chain"));
    select(SetupOwner::analysis, "bar");
    wait_until_idle();
    EXPECT_EQ(verdict(), "") << "nothing is required";
    require("L", {1.0, Unit::of("mm")});
    EXPECT_TRUE(verdict().starts_with("met")) << verdict();
    const auto whole = [this] { return answer().verdict().accessibleName(); };
    EXPECT_TRUE(whole().contains(QString::fromUtf8("met: U 0.0054 ≤ 1"))) << to_std(whole());
    EXPECT_EQ(answer().verdict().kind(), Chip::Kind::met);
    require("L", {1e-6, Unit::of("mm")});
    EXPECT_TRUE(verdict().starts_with("not met")) << verdict();
    EXPECT_TRUE(whole().contains(QString::fromUtf8(" > 1"))) << to_std(whole());
    EXPECT_EQ(answer().verdict().kind(), Chip::Kind::not_met);
}

TEST_F(AnswerSession, WhatIsNotOfThePresentSaysSo) {
    window_->runner().set_live(false);
    open_and_wait(QStringLiteral("chain"));
    select(SetupOwner::analysis, "bar");
    trigger(QStringLiteral("Run This Analysis"));
    wait_until_idle();
    ASSERT_TRUE(status().is_current());
    const std::string before = value();
    window_->document().apply(QStringLiteral("More"),
                              [](Project& project) { bar_of(project).options.coverage_probability = 0.99; });
    wait_until_idle();
    EXPECT_EQ(value(), before);
    EXPECT_EQ(verdict(), "out of date");
    EXPECT_EQ(answer().verdict().kind(), Chip::Kind::neutral);
    EXPECT_TRUE(answer().statements().contains(QStringLiteral("Out of date"))) << "also where it is copied";
    trigger(QStringLiteral("Run This Analysis"));
    wait_until_idle();
    EXPECT_EQ(verdict(), "");
    EXPECT_NE(answer().coverage().text().letters().find("p = " + percent_text(0.99)), std::string::npos);
}

TEST_F(AnswerSession, KAndPGiveWayBeforeTheValue) {
    open_and_wait(QStringLiteral("chain"));
    select(SetupOwner::analysis, "bar");
    wait_until_idle();
    AnswerStrip strip(window_->document(), window_->runner(), window_->selection());
    strip.take_result();
    strip.resize(900, strip.height());
    strip.show();
    settle();
    EXPECT_FALSE(strip.coverage().isHidden());
    strip.resize(strip.value().sizeHint().width() + 220, strip.height());
    settle();
    EXPECT_TRUE(strip.coverage().isHidden());
    EXPECT_GE(strip.value().width(), strip.value().sizeHint().width() - 1);
    EXPECT_LE(strip.minimumSizeHint().width(), 300) << "it keeps no window wide";
}

}  // namespace
}  // namespace covaria::ui::answer_session_test
