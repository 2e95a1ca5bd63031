// A user finds things by their names, with the keyboard alone.
#include <QLineEdit>
#include <QTreeView>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/help_actions.h"
#include "ui/main_window/search_actions.h"
#include "ui/pages/help_pane.h"
#include "ui/pages/search_palette.h"

namespace covaria::ui::search_session_test {
namespace {

Findable named(const char* name, const char* kind) {
    return {QString::fromUtf8(name), QString::fromUtf8(kind), [] {}};
}

TEST(SearchMatch, WordsFitByTheirLettersInOrder) {
    const Findable field = named("Standard uncertainty", "field of Tracker 1");
    EXPECT_TRUE(match("", field));
    EXPECT_TRUE(match("stunc", field));
    EXPECT_TRUE(match("tracker uncert", field));
    EXPECT_FALSE(match("cnutrd", field));
    EXPECT_FALSE(match("uncertainty robot", field));
    EXPECT_GT(*match("uncertainty", field), *match("certain", field));
    EXPECT_GT(*match("run", named("Run", "command")), *match("run", named("Run All", "command")));
    Findable page = named("Run", "help");
    page.behind = true;
    EXPECT_GT(*match("run", named("Run All", "command")), *match("run", page));
    EXPECT_GT(*match("budget", named("Budget", "tab")), *match("budget", named("Tab", "Budget")));
}

TEST(SearchMatch, TheEnglishNameIsFoundInEveryLanguageBehindTheShownOne) {
    Findable field = named("Standardunsicherheit", "Feld von Tracker 1");
    EXPECT_FALSE(match("standard uncertainty", field));
    field.english = QStringLiteral("Standard uncertainty");
    EXPECT_TRUE(match("standard uncertainty", field));
    EXPECT_TRUE(match("standardunsicherheit", field));
    EXPECT_GT(*match("standardunsicherheit", field), *match("uncertainty", field));
}

class SearchSession : public Session {
protected:
    SearchPalette& palette() { return window_->search().palette(); }
    /// Types into the palette and takes the best that is called `name`.
    void find(const QString& typed, const QString& name) {
        trigger(QStringLiteral("Find Anything"));
        ASSERT_TRUE(wait_for([this] { return palette().isVisible(); }));
        QTest::keyClicks(&palette().field(), typed);
        for (int i = 0; i < 20 && current() != name; ++i) QTest::keyClick(&palette().field(), Qt::Key_Down);
        ASSERT_EQ(current(), name);
        QTest::keyClick(&palette().field(), Qt::Key_Return);
        EXPECT_FALSE(palette().isVisible());
    }
    QString current() { return palette().found().currentIndex().siblingAtColumn(0).data().toString(); }
};

TEST_F(SearchSession, EntriesFieldsResultsTabsCommandsAndHelpAreGoneTo) {
    open(project_copy());
    wait_until_idle();
    const Project& project = window_->document().project();
    const AssetEntry& asset = project.assets.front();
    find(to_qt(asset.name), to_qt(asset.name));
    EXPECT_EQ(window_->selection().entry(), (SetupAddress{SetupOwner::asset, asset.id}));

    const AnalysisEntry& analysis = project.analyses.front();
    const SetupAddress entry{SetupOwner::analysis, analysis.id};
    const FieldSpec& field = find_schema(project, entry)->fields().front();
    find(to_qt(field.title + " " + analysis.name), to_qt(field.title));
    EXPECT_EQ(window_->selection().entry(), entry);
    EXPECT_TRUE(window_->properties().isAncestorOf(QApplication::focusWidget()));

    ASSERT_TRUE(status().result);
    const OutputQuantity& output = status().result->outputs[1].quantity;
    trigger(QStringLiteral("Find Anything"));
    QTest::keyClicks(&palette().field(), QStringLiteral("result of ") + to_qt(analysis.name));
    QTest::keyClick(&palette().field(), Qt::Key_Down);
    QTest::keyClick(&palette().field(), Qt::Key_Return);
    EXPECT_EQ(window_->selection().output(), 1) << output.symbol;

    find(QStringLiteral("Charts tab"), QStringLiteral("Charts"));
    EXPECT_EQ(window_->results().tabs().tabText(window_->results().tabs().currentIndex()),
              QStringLiteral("Charts"));

    const std::size_t analyses = project.analyses.size();
    window_->selection().select_entry(entry);
    find(QStringLiteral("Duplicate command"), QStringLiteral("Duplicate"));
    EXPECT_EQ(window_->document().project().analyses.size(), analyses + 1);

    find(QStringLiteral("coverage factor help"), QStringLiteral("coverage factor"));
    EXPECT_TRUE(window_->help().pane().isVisible());
    EXPECT_TRUE(window_->help().pane().place().startsWith(QStringLiteral("glossary")))
        << to_std(window_->help().pane().place());

    trigger(QStringLiteral("Find Anything"));
    QTest::keyClicks(&palette().field(), QStringLiteral("no such thing qqq"));
    EXPECT_EQ(palette().found().model()->rowCount(), 0);
    QTest::keyClick(&palette().field(), Qt::Key_Return);
    QTest::keyClick(&palette().field(), Qt::Key_Escape);
    EXPECT_FALSE(palette().isVisible());
}

TEST_F(SearchSession, LooksAsItShould) {
    open(project_copy());
    wait_until_idle();
    trigger(QStringLiteral("Find Anything"));
    QTest::keyClicks(&palette().field(), QStringLiteral("unc"));
    EXPECT_GT(palette().found().model()->rowCount(), 3);
    settle();
    palette().grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/search-palette.png"));
}

}  // namespace
}  // namespace covaria::ui::search_session_test
