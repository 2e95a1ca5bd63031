// The form of the certificate: a field for every text that is declared, live, undone, quiet where it is
// empty.
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>

#include "tests/fresh_folder.h"
#include "tests/ui/qt_application.h"
#include "ui/forms/certificate_form.h"
#include "ui/forms/complaint.h"
#include "ui/forms/date_editor.h"
#include "ui/forms/file_editor.h"
#include "ui/forms/report_form.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui::certificate_form_test {
namespace {

struct CertificateFormTest : testing::Test {
    CertificateFormTest() {
        auto* sections = form.findChild<FoldGroups*>();
        for (int section = 0; section < sections->count(); ++section) sections->open(section);
        form.show();
        QApplication::setActiveWindow(&form);
    }
    template <class Widget>
    Widget* find(std::string Certificate::*member) {
        return form.findChild<Widget*>(QString::fromStdString(pointer_of(certificate_field(member))));
    }
    const Certificate& certificate() const { return document.project().certificate; }
    void type(QLineEdit* edit, const QString& text) {
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    QString state() { return form.findChild<QLabel*>(QStringLiteral("certificate_state"))->text(); }

    Document document{[](const MadeProject& made) { return made.problems(); }, nullptr};
    CertificateForm form{document};
};

TEST_F(CertificateFormTest, EveryTextHasAFieldOfItsKindAndNoneIsMarked) {
    for (const CertificateField& field : certificate_fields()) {
        const QString name = QString::fromStdString(pointer_of(field));
        QWidget* widget = form.findChild<QWidget*>(name);
        ASSERT_NE(widget, nullptr) << name.toStdString();
        EXPECT_EQ(qobject_cast<QPlainTextEdit*>(widget) != nullptr, field.kind == CertificateText::lines)
            << name.toStdString();
        EXPECT_EQ(form.findChild<QWidget*>(name + QStringLiteral("/last")) != nullptr,
                  field.kind == CertificateText::dates)
            << name.toStdString();
        EXPECT_EQ(complaint_of(*widget), QString()) << "nothing is red at the start";
        EXPECT_TRUE(widget->toolTip().contains(QString::fromLatin1(field.help)));
        EXPECT_EQ(widget->toolTip().contains(QString::fromLatin1(field.clause)), true);
        const QVariant hint = widget->property("placeholderText");
        EXPECT_EQ(hint.toString().contains(QStringLiteral("17025")), field.required) << name.toStdString();
    }
}

TEST_F(CertificateFormTest, ASectionSaysHowMuchOfItIsStated) {
    const auto* sections = form.findChild<FoldGroups*>();
    const auto summary = [&] {
        QStringList words;
        for (int section = 0; section < sections->count(); ++section)
            words << sections->head(section)->summary();
        return words.join(QStringLiteral(", "));
    };
    EXPECT_FALSE(summary().contains(QStringLiteral("1 of "))) << summary().toStdString();
    type(find<QLineEdit>(&Certificate::number), QStringLiteral("2026-17"));
    EXPECT_TRUE(summary().contains(QStringLiteral("1 of "))) << summary().toStdString();
}

TEST_F(CertificateFormTest, ALogoBesideTheProjectIsNamedRelativeToIt) {
    auto* edit = find<QLineEdit>(&Certificate::logo);
    auto* editor = qobject_cast<FileEditor*>(edit->parentWidget());
    ASSERT_NE(editor, nullptr);
    const std::filesystem::path folder = covaria::test::fresh_folder();
    ASSERT_TRUE(document.save_as(from_path(folder / "a.covaria")));
    editor->choose(from_path(folder / "pictures/logo.png"));
    EXPECT_EQ(certificate().logo, "pictures/logo.png");
    EXPECT_EQ(edit->text(), QStringLiteral("pictures/logo.png"));
    editor->choose(QStringLiteral("/lab/logo.png"));  // elsewhere
    EXPECT_EQ(certificate().logo, "/lab/logo.png");
    document.undo_stack().undo();
    EXPECT_EQ(edit->text(), QString()) << "edits of a field in a row are one step";
    type(edit, QStringLiteral("other.jpg"));
    EXPECT_EQ(certificate().logo, "other.jpg");
}

TEST_F(CertificateFormTest, TypingIsLiveAndOneStepToUndo) {
    auto* number = find<QLineEdit>(&Certificate::number);
    number->setFocus();
    QTest::keyClicks(number, QStringLiteral("2026-17"));
    EXPECT_EQ(certificate().number, "2026-17");
    auto* method = find<QPlainTextEdit>(&Certificate::method);
    method->setFocus();
    QTest::keyClicks(method, QStringLiteral("MP-12"));
    QTest::keyClick(method, Qt::Key_Return);
    QTest::keyClicks(method, QStringLiteral("2nd edition"));
    EXPECT_EQ(certificate().method, "MP-12\n2nd edition");
    EXPECT_EQ(document.undo_stack().count(), 2);
    document.undo_stack().undo();
    EXPECT_EQ(certificate().method, "");
    EXPECT_EQ(method->toPlainText(), "");
    document.undo_stack().undo();
    EXPECT_EQ(number->text(), "");
    document.undo_stack().redo();
    EXPECT_EQ(number->text(), "2026-17");
    EXPECT_EQ(certificate().number, "2026-17");
}

TEST_F(CertificateFormTest, DatesAreTypedInSeveralWaysAndKeptInOne) {
    type(find<QLineEdit>(&Certificate::issued), QStringLiteral("20.4.2026"));
    EXPECT_EQ(certificate().issued, "2026-04-20");
    EXPECT_EQ(find<QLineEdit>(&Certificate::issued)->text(), "2026-04-20");
    type(find<QLineEdit>(&Certificate::calibrated), QStringLiteral("2026-04-17"));
    EXPECT_EQ(certificate().calibrated, "2026-04-17");
    auto* last = form.findChild<QLineEdit*>(
        QString::fromStdString(pointer_of(certificate_field(&Certificate::calibrated))) +
        QStringLiteral("/last"));
    type(last, QStringLiteral("2026-4-18"));
    EXPECT_EQ(certificate().calibrated, "2026-04-17/2026-04-18");
    EXPECT_EQ(last->text(), "2026-04-18");
    type(last, QStringLiteral("2026-04-16"));
    EXPECT_EQ(certificate().calibrated, "2026-04-17/2026-04-18") << "no interval ends before it begins";
    EXPECT_NE(complaint_of(*last), QString());
    type(last, QStringLiteral("2026-04-17"));
    EXPECT_EQ(certificate().calibrated, "2026-04-17") << "one day";
    EXPECT_EQ(complaint_of(*last), QString());
}

TEST_F(CertificateFormTest, ATextThatIsNoDateIsKeptAsUnreadAndSaid) {
    auto* issued = find<QLineEdit>(&Certificate::issued);
    type(issued, QStringLiteral("2026-04-20"));
    type(issued, QStringLiteral("soon"));
    EXPECT_EQ(certificate().issued, "2026-04-20");
    EXPECT_EQ(issued->text(), "soon");
    EXPECT_TRUE(complaint_of(*issued).contains(QStringLiteral("soon")));
    ASSERT_FALSE(document.problems().items().empty());
    EXPECT_EQ(document.problems().items()[0].path, "/certificate/dates/issued");
    EXPECT_TRUE(document.unread().held(document.project()).analyses.empty()) << "no run depends on it";
    {
        CertificateForm other(document);
        EXPECT_EQ(other.findChild<QLineEdit*>(issued->objectName())->text(), "soon") << "not forgotten";
    }
    type(issued, QStringLiteral("2026-04-21"));
    EXPECT_EQ(certificate().issued, "2026-04-21");
    EXPECT_TRUE(document.problems().items().empty());
    EXPECT_EQ(complaint_of(*issued), QString());
}

TEST_F(CertificateFormTest, WhatIsMissingIsCountedAndTheNextIsAStepAway) {
    EXPECT_TRUE(state().contains(QStringLiteral("Export"))) << state().toStdString();
    form.focus_next_missing();
    EXPECT_TRUE(find<QLineEdit>(&Certificate::number)->hasFocus());
    QTest::keyClicks(find<QLineEdit>(&Certificate::number), QStringLiteral("1"));
    EXPECT_EQ(find<QLineEdit>(&Certificate::number)->placeholderText(), "");
    EXPECT_TRUE(state().contains(QStringLiteral("Laboratory"))) << state().toStdString();
    form.focus_next_missing();
    EXPECT_TRUE(find<QLineEdit>(&Certificate::laboratory)->hasFocus());
    document.apply(QStringLiteral("All"), [](Project& project) {
        for (const CertificateField& field : certificate_fields())
            if (field.required) project.certificate.*field.member = "2026-04-17";
    });
    EXPECT_TRUE(state().startsWith(QStringLiteral("Everything"))) << state().toStdString();
    EXPECT_TRUE(form.focus_field("/certificate/authorised/name"));
    EXPECT_TRUE(find<QLineEdit>(&Certificate::authorised_by)->hasFocus());
    EXPECT_FALSE(form.focus_field("/certificate"));
}

TEST(ReportForm, BoxesFollowTheProjectAndAreUndone) {
    Document document([](const MadeProject&) { return Problems(); }, nullptr);
    document.apply(QStringLiteral("Add"), [](Project& project) {
        project.analyses.push_back({.id = "a", .model = "m", .name = "First & last"});
        project.analyses.push_back({.id = "b", .model = "m", .name = "Second"});
    });
    ReportForm form(document);
    form.show();
    const auto box = [&](const char* name) { return form.findChild<QCheckBox*>(QString::fromLatin1(name)); };
    for (const QCheckBox* each : form.findChildren<QCheckBox*>())
        EXPECT_EQ(each->isChecked(), each != box("report:annex")) << each->objectName().toStdString();
    box("report:a")->click();
    box("report:scene")->click();
    box("report:annex")->click();
    EXPECT_EQ(document.project().report, (ReportContents{{"a"}, {"scene"}, true}));
    document.undo_stack().undo();
    document.undo_stack().undo();
    EXPECT_TRUE(box("report:scene")->isChecked());
    EXPECT_FALSE(box("report:a")->isChecked());
    document.apply(QStringLiteral("Rename"), [](Project& project) { project.analyses[0].name = "One"; });
    EXPECT_EQ(box("report:a")->text(), "One");
    EXPECT_FALSE(box("report:a")->isChecked());
    document.apply(QStringLiteral("Delete"),
                   [](Project& project) { project.analyses.erase(project.analyses.begin()); });
    EXPECT_EQ(box("report:a"), nullptr);
    EXPECT_NE(box("report:b"), nullptr);
}

}  // namespace
}  // namespace covaria::ui::certificate_form_test
