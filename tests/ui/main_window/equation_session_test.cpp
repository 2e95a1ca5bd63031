// A user opens a worked example of the GUM, makes a mistake in the equation, repairs it, sets a requirement
// and reads the verdict; and builds a budget from nothing.
#include <QDir>
#include <QLineEdit>

#include "core/document/document_writers.h"
#include "core/report/report.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/lines_editor.h"
#include "ui/forms/requirements_form.h"
#include "ui/pages/current_results.h"
#include "ui/scene_view/equations_view.h"

namespace covaria::ui::equation_session_test {
namespace {

class EquationSession : public Session {
protected:
    void open_gauge_block() {
        const QString file = QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/s1-9.5-gauge-block.covaria");
        const QString copy = folder_.filePath(QStringLiteral("gauge-block.covaria"));
        ASSERT_TRUE(QFile::copy(file, copy));
        open(copy);
        select(SetupOwner::analysis, "gauge-block");
        ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
    }
    LinesEditor& equations() {
        auto* editor = window_->properties().findChild<LinesEditor*>();
        EXPECT_NE(editor, nullptr);
        return *editor;
    }
    void type_equations(const QString& text) {
        QPlainTextEdit* edit = equations().text_edit();
        edit->setFocus();
        edit->selectAll();
        edit->insertPlainText(text);
    }
    void keep_picture(const QString& name) {
        QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        window_->grab().save(folder.filePath(name));
    }
};

TEST_F(EquationSession, AMistakeIsMarkedAndRepaired) {
    open_gauge_block();
    const QString right = equations().text_edit()->toPlainText();
    auto* shown = window_->findChild<EquationsView*>();
    ASSERT_NE(shown, nullptr);
    EXPECT_TRUE(wait_for([&] {
        return shown->isVisible() && shown->accessibleDescription().contains(QStringLiteral("= L_S + D"));
    })) << to_std(shown->accessibleDescription());
    type_equations(QStringLiteral("delta_L = L_S + theta_0"));
    ASSERT_TRUE(wait_for([&] { return !equations().text_edit()->extraSelections().isEmpty(); }));
    EXPECT_EQ(equations().text_edit()->extraSelections().first().cursor.selectedText(), QStringLiteral("+"));
    EXPECT_TRUE(problems().join(QLatin1Char('\n')).contains(QStringLiteral("cannot be added")));
    keep_picture(QStringLiteral("equation-mistake.png"));
    type_equations(right);
    EXPECT_TRUE(wait_for([&] { return equations().text_edit()->extraSelections().isEmpty(); }));
    EXPECT_TRUE(wait_for([&] { return shown->isVisible(); })) << "the equations are shown again";
    keep_picture(QStringLiteral("equation.png"));
}

TEST_F(EquationSession, EquationsCanBeEmptiedAndWrittenAnew) {
    open_gauge_block();
    QPlainTextEdit* edit = equations().text_edit();
    edit->setFocus();
    QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(edit, Qt::Key_Delete);
    QTest::qWait(300);  // nothing comes back of itself
    EXPECT_EQ(edit->toPlainText(), QString());
    const QStringList said = problems();
    EXPECT_TRUE(said.join(QLatin1Char('\n')).contains(QStringLiteral("must not be empty")))
        << to_std(said.join('|'));
    QTest::keyClicks(edit, QStringLiteral("M = c"));
    EXPECT_EQ(edit->toPlainText(), QStringLiteral("M = c"));
}

TEST_F(EquationSession, ARequirementIsJudged) {
    open_gauge_block();
    show_group(QStringLiteral("Requirements"));
    auto* form = window_->properties().findChild<RequirementsForm*>();
    ASSERT_NE(form, nullptr);
    ASSERT_TRUE(wait_for([&] { return form->outputs()->count() == 1; }));
    type_into("targetUncertainty", QStringLiteral("80 nm"));
    type_into("upperLimit", QStringLiteral("1000"));
    const auto& requirements = window_->document().project().analyses[0].requirements;
    ASSERT_EQ(requirements.size(), 1u);
    EXPECT_EQ(requirements[0].upper_limit, (Quantity{1000.0, Unit::of("nm")}));
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([&] { return form->verdict()->text().contains(QStringLiteral("not met")); }))
        << form->verdict()->text().toStdString();
    EXPECT_TRUE(wait_for([&] { return form->verdict()->text().contains(QStringLiteral("reduced from")); }));
    EXPECT_TRUE(form->verdict()->text().contains(QStringLiteral("accepted")));
    keep_picture(QStringLiteral("requirements.png"));
    for (const char* name : {"targetUncertainty", "upperLimit"}) {
        auto* edit = field<QLineEdit>(name);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    EXPECT_TRUE(window_->document().project().analyses[0].requirements.empty());
}

// A verdict is never old: a limit changed after the run is judged at once, in the form and in the report, and
// the result stays up to date.
TEST_F(EquationSession, AChangedLimitIsJudgedAtOnce) {
    open_gauge_block();
    show_group(QStringLiteral("Requirements"));
    auto* form = window_->properties().findChild<RequirementsForm*>();
    ASSERT_NE(form, nullptr);
    ASSERT_TRUE(wait_for([&] { return form->outputs()->count() == 1; }));
    type_into("upperLimit", QStringLiteral("1000"));
    trigger(QStringLiteral("Run This Analysis"));
    ASSERT_TRUE(wait_for([&] { return form->verdict()->text().contains(QStringLiteral("accepted")); }));
    ASSERT_TRUE(wait_for([&] { return status().state == RunState::up_to_date; }));
    const auto result = status().result;
    const auto is_same_run = [&] {  // names may be taken over from the project of now
        return status().result->trials == result->trials &&
               status().result->outputs[0].expanded_uncertainty == result->outputs[0].expanded_uncertainty;
    };
    const auto report = [&] {
        const Project& project = window_->document().project();
        return to_markdown(
            build_report(*MadeProject::make(project), current_results(project, window_->runner())));
    };
    EXPECT_NE(report().find("accepted"), std::string::npos);
    type_into("upperLimit", QStringLiteral("850"));
    EXPECT_TRUE(form->verdict()->text().contains(QStringLiteral("rejected")))
        << form->verdict()->text().toStdString();
    EXPECT_EQ(status().state, RunState::up_to_date);
    EXPECT_TRUE(is_same_run()) << "a requirement does not change the result";
    EXPECT_EQ(report().find("accepted"), std::string::npos);
    EXPECT_NE(report().find("rejected"), std::string::npos);
    type_into("targetUncertainty", QStringLiteral("80 nm"));
    EXPECT_TRUE(form->verdict()->text().contains(QStringLiteral("not met")));
    EXPECT_TRUE(wait_for([&] { return form->verdict()->text().contains(QStringLiteral("reduced from")); }));
    type_into("targetUncertainty", QStringLiteral("200 nm"));
    EXPECT_FALSE(form->verdict()->text().contains(QStringLiteral("not met")));
    EXPECT_TRUE(is_same_run());
}

// 17.4: live mode judges as well, first by the law of propagation, then by the trials.
TEST_F(EquationSession, LiveModeJudges) {
    open_gauge_block();
    show_group(QStringLiteral("Requirements"));
    auto* form = window_->properties().findChild<RequirementsForm*>();
    ASSERT_NE(form, nullptr);
    ASSERT_TRUE(wait_for([&] { return form->outputs()->count() == 1; }));
    type_into("upperLimit", QStringLiteral("1000"));
    window_->runner().set_live(true);
    ASSERT_TRUE(wait_for([&] { return form->verdict()->text().contains(QStringLiteral("accepted")); }))
        << form->verdict()->text().toStdString();
    ASSERT_TRUE(wait_for([&] { return status().state == RunState::up_to_date; }));
    EXPECT_TRUE(form->verdict()->text().contains(QStringLiteral("(trials)")));
    type_into("upperLimit", QStringLiteral("850"));
    EXPECT_TRUE(form->verdict()->text().contains(QStringLiteral("rejected")));
}

}  // namespace
}  // namespace covaria::ui::equation_session_test
