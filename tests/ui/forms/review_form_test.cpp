// The review of the project in the inspector: names typed, released, a draft again after any edit, undone.
#include "ui/forms/review_form.h"

#include <gtest/gtest.h>

#include <QDate>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <memory>

#include "core/project/release.h"
#include "tests/ui/qt_application.h"
#include "ui/theme/strings.h"

namespace covaria::ui::review_form_test {
namespace {

struct ReviewFormTest : testing::Test {
    ReviewFormTest() {
        EXPECT_FALSE(
            document.open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/certificate-gauge-block.covaria"))
                .has_errors());
        form = std::make_unique<ReviewForm>(document);
        form->show();
        QApplication::setActiveWindow(form.get());
        document.set_merge_window(0);
    }
    void type(const char* name, const QString& text) {
        auto* edit = form->findChild<QLineEdit*>(QLatin1String(name));
        ASSERT_NE(edit, nullptr) << name;
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    void type_names() {
        type("/review/prepared/name", QStringLiteral("A. Ames"));
        type("/review/checked/name", QStringLiteral("B. Bell"));
        type("/review/released/name", QStringLiteral("C. Cole"));
    }
    QPushButton& button(const char* name) { return *form->findChild<QPushButton*>(QLatin1String(name)); }
    std::string says() const {
        return to_std(form->findChild<QLabel*>(QStringLiteral("review_state"))->text());
    }
    ReleaseState state() const { return release_status(document.project()).state; }

    Document document{[](const MadeProject& made) { return made.problems(); }, nullptr};
    std::unique_ptr<ReviewForm> form;
    const std::string today = to_std(QDate::currentDate().toString(Qt::ISODate));
};

TEST_F(ReviewFormTest, IsReleasedAndADraftAgainAfterAnEdit) {
    EXPECT_FALSE(button("release").isEnabled()) << "nobody is named";
    type("/review/prepared/name", QStringLiteral("A. Ames"));
    EXPECT_NE(says().find("Draft: it was not released"), std::string::npos) << says();
    type_names();
    type("/review/prepared/date", QStringLiteral("2026-01-02"));
    ASSERT_TRUE(button("release").isEnabled());
    const int steps = document.undo_stack().index();
    button("release").click();
    EXPECT_EQ(document.undo_stack().index(), steps + 1);
    EXPECT_EQ(state(), ReleaseState::released);
    EXPECT_EQ(document.project().review.prepared.date, "2026-01-02");
    EXPECT_EQ(document.project().review.released.date, today);
    EXPECT_NE(says().find("Released by C. Cole on " + today), std::string::npos) << says();
    EXPECT_FALSE(button("release").isEnabled()) << "there is nothing new";
    QString summary;
    QObject::connect(form.get(), &ReviewForm::summary_changed, form.get(),
                     [&](const QString& words) { summary = words; });
    document.apply(QStringLiteral("one digit"),
                   [](Project& project) { project.analyses[0].options.coverage_factor = 2.1; });
    EXPECT_EQ(summary, QStringLiteral("draft again"));
    EXPECT_NE(says().find("Draft again: changed since it was released by C. Cole"), std::string::npos);
    EXPECT_NE(says().find("analysis '" + document.project().analyses[0].name + "'"), std::string::npos)
        << says();
    document.undo();
    EXPECT_EQ(summary, QStringLiteral("released"));
    document.undo();
    EXPECT_EQ(summary, QStringLiteral("draft")) << "the release itself is undone";
}

TEST_F(ReviewFormTest, AReleaseAfterAChangeIsOfToday) {
    type_names();
    type("/review/released/date", QStringLiteral("2026-01-02"));
    button("release").click();
    EXPECT_EQ(document.project().review.released.date, "2026-01-02") << "as it was typed";
    document.apply(QStringLiteral("title"), [](Project& project) { project.title += "."; });
    ASSERT_EQ(state(), ReleaseState::changed);
    button("release").click();
    EXPECT_EQ(state(), ReleaseState::released);
    EXPECT_EQ(document.project().review.released.date, today);
}

TEST_F(ReviewFormTest, TheLogHasWhatWasDone) {
    type_names();
    button("release").click();
    type("log_who", QStringLiteral("A. Ames"));
    type("log_what", QStringLiteral("Sent to the customer"));
    ASSERT_EQ(document.project().review.log.size(), 2u);
    EXPECT_EQ(document.project().review.log[1], (ReviewEntry{today, "A. Ames", "Sent to the customer"}));
    const QString shown = form->findChild<QLabel*>(QStringLiteral("review_log"))->text();
    EXPECT_TRUE(shown.contains(QStringLiteral("A. Ames: Sent to the customer"))) << to_std(shown);
    EXPECT_EQ(state(), ReleaseState::released) << "a line of the log changes nothing";
    button("add_to_log").click();
    EXPECT_EQ(document.project().review.log.size(), 2u) << "nothing was typed";
}

TEST_F(ReviewFormTest, WithErrorsNothingIsReleasedAndTheirPlaceGetsTheFocus) {
    type_names();
    document.apply(QStringLiteral("wrong"), [](Project& project) { project.review.checked.date = "soon"; });
    document.check_now();
    ASSERT_TRUE(document.problems().has_errors());
    EXPECT_FALSE(button("release").isEnabled());
    EXPECT_TRUE(form->focus_field("/review/checked/date"));
    EXPECT_FALSE(form->focus_field("/certificate/number"));
}

}  // namespace
}  // namespace covaria::ui::review_form_test
