// A user opens a worked example of the GUM, makes a mistake in the equation, repairs it, sets a requirement
// and reads the verdict; and builds a budget from nothing.
#include <QDir>
#include <QLineEdit>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/lines_editor.h"
#include "ui/forms/requirements_form.h"
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
    EXPECT_TRUE(wait_for([&] { return shown->isVisible(); }));
    EXPECT_TRUE(shown->accessibleDescription().contains(QString::fromUtf8("= L_S + D")))
        << to_std(shown->accessibleDescription());
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

TEST_F(EquationSession, ARequirementIsJudged) {
    open_gauge_block();
    show_tab(QStringLiteral("Requirements"));
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
    EXPECT_TRUE(form->verdict()->text().contains(QStringLiteral("reduced from")));
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

}  // namespace
}  // namespace covaria::ui::equation_session_test
