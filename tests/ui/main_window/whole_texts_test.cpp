// No text of the window is cut, in any language.
#include <QDir>
#include <QMenuBar>
#include <QTabWidget>
#include <QTranslator>

#include "tests/ui/main_window/cut_texts.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/impact_actions.h"
#include "ui/main_window/impact_dialog.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/pages/library_browser.h"
#include "ui/theme/languages.h"

namespace covaria::ui::whole_texts_test {
namespace {

/// The window in the language of a catalogue; English needs none.
class WholeTexts : public Session, public testing::WithParamInterface<const char*> {
protected:
    WholeTexts() {
        const QString code = QString::fromLatin1(GetParam());
        is_offered_ = offered_language(code) == code;
        if (!is_offered_) return;
        if (catalogue_.load(QStringLiteral(":/translations/covaria_%1.qm").arg(code)))
            QCoreApplication::installTranslator(&catalogue_);
        window_->close();
        make_window();
    }
    ~WholeTexts() override { QCoreApplication::removeTranslator(&catalogue_); }

    /// Leaves a picture in the build folder, for people.
    void shoot(const QString& what) {
        settle();
        const QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        window_->grab().save(
            folder.filePath(QStringLiteral("language-%1-%2.png").arg(QString::fromLatin1(GetParam()), what)));
    }
    /// Tables may scroll, and their cells may be long; a bar may put tabs into its menu; an origin is what a
    /// file says.
    static QStringList cut(const QWidget& top) {
        QStringList found = cut_texts(top);
        found.removeIf([](const QString& one) {
            for (const char* may_be : {"scrolls sideways", "cell", "line QLineEdit origin"})
                if (one.startsWith(QLatin1String(may_be))) return true;
            return false;
        });
        return found;
    }
    static void expect_whole(const QWidget& top) {
        // Forms break their rows anew when a bar has appeared.
        (void)QTest::qWaitFor([&] { return cut(top).isEmpty(); }, 500);
        EXPECT_EQ(cut(top).join(QLatin1Char('\n')).toStdString(), "");
    }
    void expect_whole_tabs(QTabWidget& tabs, const QWidget& pane, const QString& name) {
        const int before = tabs.currentIndex();
        for (int i = 0; i < tabs.count(); ++i) {
            if (!tabs.isTabEnabled(i)) continue;
            ASSERT_TRUE(tabs.isVisible());
            tabs.setCurrentIndex(i);
            for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();
            if (!name.isEmpty()) settle();
            expect_whole(pane);
            if (!name.isEmpty()) shoot(name + QString::number(i));
        }
        tabs.setCurrentIndex(before);
    }

    void expect_whole_groups() {
        FoldGroups& groups = window_->properties().groups();
        for (FoldGroups* sections : window_->properties().findChildren<FoldGroups*>())
            for (int i = 0; i < sections->count(); ++i) sections->open(i);
        for (int i = 0; i < groups.count(); ++i) {
            window_->properties().show_group(i);
            for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();
            expect_whole(window_->properties());
        }
    }

    QTranslator catalogue_;
    bool is_offered_ = false;
};

TEST_P(WholeTexts, StandInTheWindowAndItsDialogs) {
    if (!is_offered_) GTEST_SKIP() << GetParam() << " is in work";
    settle();
    expect_whole(*window_);
    shoot(QStringLiteral("start"));
    const auto* bar = window_->menuBar();
    for (QAction* menu : bar->actions())
        EXPECT_TRUE(bar->rect().contains(bar->actionGeometry(menu))) << menu->text().toStdString();
    PreferenceStore store;
    PreferencesDialog preferences(store);
    preferences.show();
    settle();
    expect_whole(preferences);
    LibraryBrowser browser;
    browser.show();
    settle();
    expect_whole(browser);
    ImpactDialog& impact = window_->impact().dialog();
    impact.show();
    settle();
    expect_whole(impact);
    impact.grab().save(
        QStringLiteral(COVARIA_BINARY_DIR "/screenshots/impact-%1.png").arg(QLatin1String(GetParam())));
    open(project_copy());
    wait_until_idle();
    for (const AnalysisEntry& analysis : window_->document().project().analyses) {
        select(SetupOwner::analysis, analysis.id);
        expect_whole_tabs(window_->results().tabs(), *window_, to_qt(analysis.id) + QLatin1Char('-'));
    }
}

/// All forms of all kinds that the examples have.
TEST_P(WholeTexts, StandInTheProperties) {
    if (!is_offered_) GTEST_SKIP() << GetParam() << " is in work";
    for (const char* file : {"chain", "force-moment-sensor", "lsm-network", "stewart-platform",
                             "ballbar-design", "gum/h1-end-gauge"}) {
        open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/%1.covaria").arg(QLatin1String(file)));
        window_->runner().stop_all();
        const Project project = window_->document().project();
        std::vector<SetupAddress> entries;
        for (const AssetEntry& asset : project.assets) entries.push_back({SetupOwner::asset, asset.id});
        for (const AnalysisEntry& analysis : project.analyses)
            entries.push_back({SetupOwner::analysis, analysis.id});
        for (const SetupAddress& entry : entries) {
            SCOPED_TRACE(std::string(file) + ", " + entry.id);
            window_->selection().select_entry(entry);
            for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();  // the tabs are new
            expect_whole_groups();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Each, WholeTexts, testing::Values("en", "de", "es", "pt", "zh_CN", "ko"),
                         [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace covaria::ui::whole_texts_test
