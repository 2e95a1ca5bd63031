// Library and templates through the real widgets, and an analysis that lacks something.
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QTextBrowser>
#include <QTranslator>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/document/project_edits.h"
#include "ui/pages/answer_strip.h"
#include "ui/pages/example_card.h"
#include "ui/pages/library_browser.h"
#include "ui/pages/project_pane.h"
#include "ui/pages/question_tile.h"
#include "ui/pages/results_pane.h"
#include "ui/pages/start_page.h"
#include "ui/theme/core_text.h"
#include "ui/theme/typeset_label.h"

namespace covaria::ui::library_session_test {
namespace {

using LibrarySession = Session;

TEST_F(LibrarySession, ATrackerIsFoundByItsNameAndTakenIntoTheProject) {
    open(project_copy());
    LibraryBrowser& library = window_->library();
    library.show();
    const int all = library.cards().count();
    EXPECT_GT(all, 60) << "templates, examples and assets";
    QTest::keyClicks(&library.search(), QStringLiteral("at960"));
    ASSERT_EQ(library.cards().count(), 1);
    EXPECT_TRUE(library.details().toPlainText().contains(QStringLiteral("brochure")));
    const std::size_t before = window_->document().project().assets.size();
    library.take_button().click();
    ASSERT_EQ(window_->document().project().assets.size(), before + 1);
    EXPECT_EQ(window_->document().project().assets.back().name, "Leica AT960");
    EXPECT_TRUE(library.isVisible()) << "another may be wanted";
    library.search().setText(QStringLiteral("no such thing"));
    EXPECT_EQ(library.cards().count(), 0);
    EXPECT_FALSE(library.take_button().isEnabled());
}

TEST_F(LibrarySession, OpenedAgainItLooksForNothingYet) {
    trigger(QStringLiteral("Library and Examples"));
    LibraryBrowser& library = window_->library();
    const int all = library.cards().count();
    QTest::keyClicks(&library.search(), QStringLiteral("tracker-pose"));
    ASSERT_EQ(library.cards().count(), 1) << "an example is found by the name of its file";
    library.close();
    trigger(QStringLiteral("Library and Examples"));
    EXPECT_EQ(library.search().text(), QString());
    EXPECT_EQ(library.cards().count(), all);
}

// The shipped pictures are light.
TEST_F(LibrarySession, ADarkWindowDimsThePicturesOfItsCards) {
    QPixmap light(640, 400);
    light.fill(Qt::white);
    const auto middle = [&](const QColor& base) {
        QPixmap card(160, 100);
        QPalette palette;
        palette.setColor(QPalette::Base, base);
        palette.setColor(QPalette::Window, base);
        QPainter painter(&card);
        paint_card_picture(painter, QRectF(0, 0, 160, 100), light, palette);
        painter.end();
        return card.toImage().pixelColor(80, 50).lightness();
    };
    EXPECT_EQ(middle(Qt::white), 255);
    EXPECT_LT(middle(QColor(30, 32, 36)), 215);
    LibraryBrowser& library = window_->library();
    library.fill();
    const QImage card = library.cards().item(0)->icon().pixmap(160, 100).toImage();
    EXPECT_LT(card.pixelColor(0, 0).alpha(), 128) << "its corners are round";
}

// A window of another language finds the words that it shows, whatever their case, and the English ones.
TEST_F(LibrarySession, WhatIsShownInAnotherLanguageIsFoundAndTheEnglishWordsAreToo) {
    class German : public QTranslator {
    public:
        bool isEmpty() const override { return false; }
        QString translate(const char* context, const char* text, const char*, int) const override {
            const bool is_known = QLatin1String(context) == QLatin1String(core_context) &&
                                  text == analysis_templates()[1].title;
            return is_known ? QStringLiteral("Über das Endmaß") : QString();
        }
    } german;
    QCoreApplication::installTranslator(&german);
    LibraryBrowser& library = window_->library();
    library.fill();
    library.show_collection(LibraryBrowser::templates_title());
    library.search().setText(QStringLiteral("endmaß ÜBER"));
    ASSERT_EQ(library.cards().count(), 1);
    EXPECT_EQ(library.cards().item(0)->text(), QStringLiteral("Über das Endmaß"));
    library.search().setText(to_qt(analysis_templates()[1].title));
    EXPECT_EQ(library.cards().count(), 1);
    QCoreApplication::removeTranslator(&german);
}

TEST_F(LibrarySession, ACollectionShowsItsOwn) {
    LibraryBrowser& library = window_->library();
    library.show_collection(LibraryBrowser::templates_title());
    EXPECT_EQ(library.cards().count(), int(analysis_templates().size()));
    library.show_collection(LibraryBrowser::examples_title());
    const QDir shipped(QStringLiteral(COVARIA_SOURCE_DIR "/projects"));
    EXPECT_EQ(library.cards().count(), shipped.entryList({QStringLiteral("*.covaria")}, QDir::Files).size());
}

TEST_F(LibrarySession, ATemplateFromTheStartPageHasResultsAtOnce) {
    LibraryBrowser& library = window_->library();
    library.show_collection(LibraryBrowser::templates_title());
    library.search().setText(QStringLiteral("ballbars"));
    ASSERT_GE(library.cards().count(), 1);
    library.take_button().click();
    wait_until_idle();
    ASSERT_EQ(window_->document().project().analyses.size(), 1U);
    EXPECT_EQ(status().state, RunState::up_to_date) << status().message.toStdString();
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
}

/// Two clicks, or a figure and Return: the tile, and the first entry of its menu.
TEST_F(LibrarySession, EveryQuestionOfTheStartPageLeadsToAnAnalysisWithAResult) {
    for (const QuestionTile* tile : window_->findChildren<QuestionTile*>()) {
        QMenu& menu = const_cast<QuestionTile*>(tile)->menu();
        ASSERT_GE(menu.actions().size(), 2) << tile->text().toStdString();
    }
    for (int question = 0; question < 4; ++question) {
        make_window();
        auto* start = window_->findChild<StartPage*>();
        ASSERT_NE(start, nullptr);
        QTest::keyClick(start, Qt::Key(Qt::Key_1 + question));
        QMenu& menu = start->tiles()[question]->menu();
        ASSERT_TRUE(wait_for([&] { return menu.isVisible(); }, 2000)) << question;
        QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(menu.actions().front()).center());
        wait_until_idle();
        ASSERT_EQ(window_->document().project().analyses.empty(), false) << question;
        EXPECT_EQ(status().state, RunState::up_to_date) << status().message.toStdString();
        EXPECT_FALSE(window_->results().answer().value().text().empty());
        answer_.save = SaveAnswer::discard;
        window_->close();
    }
}

TEST_F(LibrarySession, ANewAnalysisOfTheMenuIsPrefilled) {
    open(project_copy());
    wait_until_idle();
    const std::size_t before = window_->document().project().analyses.size();
    window_->project_pane().add_analysis(window_->document().project().analyses.front().model);
    wait_until_idle();
    EXPECT_EQ(window_->document().project().analyses.size(), before + 1);
    EXPECT_NE(status().prepared, nullptr) << status().message.toStdString();
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
}

TEST_F(LibrarySession, WhatIsNotGivenIsIncompleteAndTheNextStepLeadsThere) {
    open(project_copy());
    wait_until_idle();
    const std::string model = window_->document().project().analyses.front().model;
    window_->selection().select_entry({SetupOwner::analysis, add_analysis(window_->document(), model)});
    wait_until_idle();
    EXPECT_EQ(status().state, RunState::incomplete);
    EXPECT_TRUE(wait_for([this] {
        return window_->scene().view().empty_text().startsWith(
            QStringLiteral("The analysis is not complete yet"));
    })) << to_std(window_->scene().view().empty_text());
    QPushButton& next = window_->results().answer().next_step();
    ASSERT_TRUE(next.isVisibleTo(window_.get()));
    EXPECT_EQ(next.text(), QStringLiteral("Next: Base points"));
    next.click();
    QWidget* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    EXPECT_TRUE(window_->properties().isAncestorOf(focus));

    press_button("base_points", QStringLiteral("Add row"));
    wait_until_idle();
    EXPECT_EQ(status().state, RunState::failed) << "an empty row is wrong, not missing";
    EXPECT_TRUE(wait_for([this] {
        return window_->scene().view().empty_text().startsWith(QStringLiteral("The analysis has problems"));
    })) << to_std(window_->scene().view().empty_text());
}

}  // namespace
}  // namespace covaria::ui::library_session_test
