// A user sets preferences: each shows at once, is remembered, and changes no result and no file.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSpinBox>

#include "core/document/document_writers.h"
#include "core/report/report.h"
#include "core/result_files/results_json.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/charts/chart_view.h"
#include "ui/forms/requirements_form.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/models/roles.h"
#include "ui/pages/all_results_tab.h"
#include "ui/pages/compare_tab.h"
#include "ui/pages/current_results.h"
#include "ui/pages/outputs_tab.h"
#include "ui/pages/sortable_table.h"
#include "ui/pages/stage.h"
#include "ui/theme/number_locale.h"

namespace covaria::ui::preferences_session_test {
namespace {

class PreferencesSession : public Session {
protected:
    ~PreferencesSession() override { apply_number_form(NumberForm::system); }

    void run() {
        open(project_copy());
        select(SetupOwner::analysis, "printed");
        window_->results().stage().show_view(&window_->results().outputs());
        trigger(QStringLiteral("Run This Analysis"));
        ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    }
    PreferencesDialog* dialog() {
        if (!window_->findChild<PreferencesDialog*>()) trigger(QStringLiteral("Preferences"));
        return window_->findChild<PreferencesDialog*>();
    }
    void choose_preference(const char* name, const QString& title) {
        auto* box = dialog()->findChild<QComboBox*>(QString::fromLatin1(name));
        ASSERT_NE(box, nullptr) << name;
        choose_in(*box, title);
    }
    const QAbstractItemModel& table() { return *window_->results().outputs().table().model(); }
    QString cell_of(const char* head, int row = 0) {
        for (int c = 0; c < table().columnCount(); ++c)
            if (table().headerData(c, Qt::Horizontal, id_role).toString() == QLatin1String(head))
                return table().index(row, c).data().toString();
        return {};
    }
    const std::vector<Requirement>& find_requirements() {
        return window_->document().project().find_analysis("printed")->requirements;
    }
    std::string results() {
        return results_json(window_->document().project(), {{status().prepared, status().result}});
    }
};

TEST_F(PreferencesSession, UnitsAndDigitsShowAtOnceAndChangeNoResult) {
    run();
    const std::string project = bytes(), json = results();
    ASSERT_EQ(cell_of("Unit"), QStringLiteral("mm"));
    const double before = cell_of("U").toDouble();
    choose_preference("lengths", QStringLiteral("thou"));
    EXPECT_EQ(cell_of("Unit"), QStringLiteral("thou"));
    EXPECT_NEAR(cell_of("U").toDouble(), before / 0.0254, 0.03 * before / 0.0254);
    EXPECT_EQ(cell_of("Unit", 3), QStringLiteral("°")) << "angles stay";
    choose_preference("digits", QStringLiteral("1"));
    EXPECT_EQ(cell_of("U").remove(QLatin1Char('.')).size(), 2) << cell_of("U").toStdString();
    EXPECT_EQ(bytes(), project);
    EXPECT_EQ(results(), json);
    EXPECT_TRUE(status().is_current()) << "nothing is computed anew";
    window_->close();
    make_window();
    EXPECT_EQ(window_->preferences().now().digits, 1);
    EXPECT_EQ(window_->preferences().now().units.of(Unit::of("m")), Unit::of("thou"));
}

TEST_F(PreferencesSession, UnitsHoldInEveryTableOfTheWindowAndInNoDocument) {
    run();
    ResultsPane& results = window_->results();
    results.stage().show_view(&results.compare_tab());
    trigger(QStringLiteral("Keep as Before"));
    show_group(QStringLiteral("Requirements"));
    auto* form = window_->properties().findChild<RequirementsForm*>();
    ASSERT_NE(form, nullptr);
    ASSERT_TRUE(wait_for([&] { return form->outputs()->count() > 0; }));
    const std::string project = bytes();
    auto* target = field<QLineEdit>("targetUncertainty");
    EXPECT_EQ(target->placeholderText(), QStringLiteral("mm"));
    choose_preference("lengths", QStringLiteral("thou"));
    dialog()->close();
    EXPECT_EQ(bytes(), project) << "nothing is stated";
    EXPECT_EQ(target->placeholderText(), QStringLiteral("thou"));
    type_into("targetUncertainty", QStringLiteral("0.001"));
    ASSERT_FALSE(find_requirements().empty());
    EXPECT_EQ(find_requirements().front().target_uncertainty, (Quantity{0.001, Unit::of("thou")}));
    EXPECT_TRUE(wait_for([&] { return form->verdict()->text().contains(QStringLiteral("thou")); }))
        << to_std(form->verdict()->text());
    EXPECT_FALSE(form->verdict()->text().contains(QRegularExpression(QStringLiteral("\\bmm\\b"))));

    const auto unit_in = [](const SortableTable& table) {
        const QAbstractItemModel& model = *table.model();
        for (int c = 0; c < model.columnCount(); ++c)
            if (model.headerData(c, Qt::Horizontal, id_role).toString() == QStringLiteral("Unit"))
                return model.index(0, c).data().toString();
        return QString();
    };
    EXPECT_EQ(unit_in(results.compare_tab().results()), QStringLiteral("thou"));
    results.stage().show_view(&results.all_results_tab());
    ASSERT_TRUE(wait_for([&] { return results.all_results_tab().table().model()->rowCount() > 0; }));
    EXPECT_EQ(unit_in(results.all_results_tab().table()), QStringLiteral("thou"));
    const std::string report = to_markdown(build_report(
        *window_->runner().made(), current_results(window_->document().project(), window_->runner())));
    EXPECT_EQ(report.find("| thou |"), std::string::npos);
    select(SetupOwner::project, "");
    EXPECT_TRUE(field<QLabel>("units_of_documents")->text().contains(QStringLiteral("preferences")));
}

TEST_F(PreferencesSession, TheFormOfNumbersIsOneInTablesFieldsAndCharts) {
    run();
    show_group(QStringLiteral("Options"));
    ASSERT_EQ(field<QLineEdit>("coverageProbability")->text(), QStringLiteral("0.95"));
    ASSERT_TRUE(cell_of("U").contains(QLatin1Char('.')));
    const std::string project = bytes(), json = results();
    choose_preference("numbers", QStringLiteral("1234,5 (comma)"));
    EXPECT_TRUE(cell_of("U").contains(QLatin1Char(','))) << cell_of("U").toStdString();
    EXPECT_EQ(field<QLineEdit>("coverageProbability")->text(), QStringLiteral("0,95"));
    type_into("coverageProbability", QStringLiteral("0,9"));
    EXPECT_EQ(window_->document().project().find_analysis("printed")->options.coverage_probability, 0.9);
    window_->document().undo_stack().undo();
    EXPECT_EQ(bytes(), project);
    ASSERT_TRUE(wait_for([this] { return status().is_current(); }));
    EXPECT_EQ(results(), json);
    choose_preference("numbers", QStringLiteral("1234.5 (point)"));
    EXPECT_TRUE(cell_of("U").contains(QLatin1Char('.')));
    EXPECT_EQ(field<QLineEdit>("coverageProbability")->text(), QStringLiteral("0.95"));
}

TEST_F(PreferencesSession, NewAnalysesBeginWithThemAndOthersStay) {
    run();
    choose_preference("coverage_factor", QStringLiteral("k = 2"));
    auto* trials = dialog()->findChild<QLineEdit*>(QStringLiteral("trials"));
    ASSERT_NE(trials, nullptr);
    EXPECT_EQ(trials->text(), QString::fromUtf8("1\u202f000\u202f000"));
    trials->selectAll();
    QTest::keyClicks(trials, QStringLiteral("50000"));
    QTest::keyClick(trials, Qt::Key_Return);
    const Project before = window_->document().project();
    window_->project_pane().add_analysis("measurement-equation");
    const Project& after = window_->document().project();
    ASSERT_EQ(after.analyses.size(), before.analyses.size() + 1);
    EXPECT_EQ(after.analyses.back().options.coverage_factor, 2.0);
    EXPECT_EQ(after.analyses.back().options.trials, 50'000u);
    for (std::size_t i = 0; i < before.analyses.size(); ++i) EXPECT_EQ(after.analyses[i], before.analyses[i]);
}

TEST_F(PreferencesSession, FontAndColoursFollowAndDefaultsComeBack) {
    run();
    const int points = qApp->font().pointSize(),
              row = window_->results().outputs().table().verticalHeader()->defaultSectionSize();
    auto* font = dialog()->findChild<QSpinBox*>(QStringLiteral("font_points"));
    ASSERT_NE(font, nullptr);
    auto* family = dialog()->findChild<QComboBox*>(QStringLiteral("font_family"));
    ASSERT_NE(family, nullptr);
    const QString ours = qApp->font().family();
    int other = 1;
    while (other < family->count() && family->itemText(other) == ours) ++other;
    ASSERT_LT(other, family->count());
    choose_in(*family, family->itemText(other));
    EXPECT_EQ(qApp->font().family(), family->itemText(other));
    choose_in(*family, QStringLiteral("Covaria's own"));
    EXPECT_EQ(qApp->font().family(), ours);
    font->setValue(18);
    choose_preference("theme", QStringLiteral("Dark"));
    QCoreApplication::processEvents();
    EXPECT_EQ(qApp->font().pointSize(), 18);
    EXPECT_GT(window_->results().outputs().table().verticalHeader()->defaultSectionSize(), row);
    EXPECT_LT(qApp->palette().color(QPalette::Window).lightness(), 100);
    QDir().mkpath(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
    settle();
    EXPECT_GE(window_->project_pane().width(), 184) << "the tree keeps room beside the stage";
    window_->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/preferences-large-dark.png"));
    dialog()->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/preferences-dialog-dark.png"));
    auto* buttons = dialog()->findChild<QDialogButtonBox*>();
    QTest::mouseClick(buttons->button(QDialogButtonBox::RestoreDefaults), Qt::LeftButton);
    QCoreApplication::processEvents();
    EXPECT_EQ(window_->preferences().now(), Preferences{});
    EXPECT_EQ(qApp->font().pointSize(), points);
    EXPECT_EQ(window_->results().outputs().table().verticalHeader()->defaultSectionSize(), row);
    dialog()->grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/preferences-dialog.png"));
}

TEST_F(PreferencesSession, SenselessStoredValuesAreAsIfThereWereNone) {
    QSettings settings;
    settings.setValue(QStringLiteral("theme"), QStringLiteral("pink"));
    settings.setValue(QStringLiteral("font_points"), 4000);
    settings.setValue(QStringLiteral("results/digits"), QStringLiteral("many"));
    settings.setValue(QStringLiteral("results/units"), QStringList{QStringLiteral("furlongs"), QString()});
    settings.setValue(QStringLiteral("autosave_seconds"), -3);
    settings.setValue(QStringLiteral("new_analyses/trials"), 1);
    EXPECT_EQ(Preferences::stored(), Preferences{});
}

}  // namespace
}  // namespace covaria::ui::preferences_session_test
