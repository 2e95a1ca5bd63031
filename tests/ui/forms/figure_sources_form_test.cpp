// The certificates of figures in the inspector: typed, undone, judged at the date of the measurement.
#include "ui/forms/figure_sources_form.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <memory>

#include "tests/ui/qt_application.h"
#include "ui/theme/strings.h"

namespace covaria::ui::figure_sources_form_test {
namespace {

const SetupAddress length{SetupOwner::analysis, "length"};

struct FigureSourcesFormTest : testing::Test {
    FigureSourcesFormTest() {
        const QString file = QStringLiteral(COVARIA_SOURCE_DIR "/docs/three-years/2025/customer-d.covaria");
        EXPECT_FALSE(document.open(file).has_errors());
        form = std::make_unique<FigureSourcesForm>(document, length);
        form->show();
        QApplication::setActiveWindow(form.get());
    }
    void type(const char* name, const QString& text) {
        auto* edit = form->findChild<QLineEdit*>(QLatin1String(name));
        ASSERT_NE(edit, nullptr) << name;
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    void press(const char* name) {
        auto* button = form->findChild<QToolButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(button->isEnabled()) << name;
        button->click();
    }
    bool says(const char* words) {
        const auto* verdict = form->findChild<QLabel*>(QStringLiteral("figures_verdict"));
        return QTest::qWaitFor([&] { return verdict->text().contains(QLatin1String(words)); }, 20'000);
    }
    const AnalysisEntry& analysis() const { return *document.project().find_analysis("length"); }

    Document document{[](const MadeProject& made) { return made.problems(); }, nullptr};
    std::unique_ptr<FigureSourcesForm> form;
};

TEST_F(FigureSourcesFormTest, TheVerdictFollowsTheDates) {
    ASSERT_EQ(form->findChild<QComboBox*>(QStringLiteral("figure_sources"))->count(), 1);
    EXPECT_TRUE(says("expired"));
    type("validUntil", QStringLiteral("2027-01-31"));
    EXPECT_EQ(analysis().certificates[0].valid_until, "2027-01-31");
    EXPECT_TRUE(says("applicable: 1."));
    document.undo();
    EXPECT_TRUE(says("expired"));
    type("measured", QStringLiteral("2026-01-30"));
    EXPECT_EQ(analysis().measured, "2026-01-30");
    EXPECT_TRUE(says("applicable: 1.")) << "another day of measurement";
}

TEST_F(FigureSourcesFormTest, CertificatesAreAddedTypedAndRemoved) {
    const int steps = document.undo_stack().index();
    press("add_source");
    ASSERT_EQ(analysis().certificates.size(), 2u);
    type("number", QStringLiteral("K 17"));
    EXPECT_EQ(analysis().certificates[1].number, "K 17");
    EXPECT_EQ(analysis().certificates[0].number, "NI 2025-0933") << "the other one stays";
    EXPECT_EQ(document.undo_stack().index(), steps + 2);
    auto* kinds = form->findChild<QComboBox*>(QStringLiteral("source_kind"));
    kinds->setCurrentIndex(2);
    emit kinds->activated(2);
    EXPECT_EQ(analysis().certificates[1].kind, FiguresFrom::data_sheet);
    press("remove_source");
    press("remove_source");
    EXPECT_TRUE(analysis().certificates.empty());
    EXPECT_TRUE(says("No certificate states")) << "and nothing is left to remove";
    EXPECT_FALSE(form->findChild<QToolButton*>(QStringLiteral("remove_source"))->isEnabled());
}

TEST_F(FigureSourcesFormTest, APlaceOfAProblemGetsTheFocus) {
    EXPECT_TRUE(form->focus_field("/analyses/0/certificates/0/validUntil"));
    EXPECT_TRUE(form->focus_field("/analyses/0/measured"));
    EXPECT_FALSE(form->focus_field("/analyses/0/setup/quantities"));
}

}  // namespace
}  // namespace covaria::ui::figure_sources_form_test
