// The page of the project: title, notes, certificate, contents of the report; and the certificate that leaves
// the window.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProcess>
#include <array>

#include "core/made/certificate_gaps.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/document/project_edits.h"
#include "ui/main_window/export_actions.h"
#include "ui/main_window/theme_switch.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/stage.h"

namespace covaria::ui::document_session_test {
namespace {

class DocumentSession : public Session {
protected:
    void go_to_project(const QString& tab) {
        window_->project_pane().setCurrentIndex(window_->project_pane().model()->index(0, 0));
        show_group(tab);
    }
    const Project& project() const { return window_->document().project(); }
    /// Everything that is required, through the fields.
    void fill_certificate() {
        go_to_project(QStringLiteral("Certificate"));
        for (const CertificateField& form_field : certificate_fields()) {
            if (!form_field.required && !form_field.required_for_conformity) continue;
            const std::string name = pointer_of(form_field);
            const QString text =
                form_field.kind == CertificateText::line || form_field.kind == CertificateText::lines
                    ? QString::fromLatin1(form_field.title)
                    : QStringLiteral("2026-04-17");
            if (form_field.kind != CertificateText::lines) {
                type_into(name.c_str(), text);
                continue;
            }
            auto* edit = field<QPlainTextEdit>(name.c_str());
            edit->setFocus();
            QTest::keyClicks(edit, text);
        }
    }
    QByteArray output_of(const QString& program, const QStringList& arguments) {
        QProcess process;
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(60'000)) << program.toStdString();
        return process.readAllStandardOutput();
    }
    /// Compares the texts of two PDFs, and every pixel of their pages.
    void expect_same_pdf(const QString& ours, const QString& theirs) {
        std::array<QByteArray, 2> texts, pictures;
        for (const std::size_t i : {0, 1}) {
            const QString& file = i == 0 ? ours : theirs;
            texts[i] = output_of(QStringLiteral("pdftotext"),
                                 {QStringLiteral("-layout"), file, QStringLiteral("-")});
            pictures[i] =
                output_of(QStringLiteral("pdftoppm"), {QStringLiteral("-r"), QStringLiteral("96"), file});
        }
        EXPECT_GT(texts[0].size(), 500);
        EXPECT_EQ(texts[0], texts[1]);
        EXPECT_GT(pictures[0].size(), 100'000);
        EXPECT_TRUE(pictures[0] == pictures[1]) << "page by page, pixel by pixel";
    }
    void run_program(const QStringList& arguments) {
        QProcess process;
        process.start(QStringLiteral(COVARIA_PROGRAM), arguments);
        ASSERT_TRUE(process.waitForFinished(300'000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    }
    void shoot(const QString& name) {
        settle();
        const QDir folder(QStringLiteral(COVARIA_BINARY_DIR "/screenshots"));
        folder.mkpath(QStringLiteral("."));
        window_->grab().save(folder.filePath(name + QStringLiteral(".png")));
    }
};

TEST_F(DocumentSession, WhatIsSaidOfAnEmptyProjectFollowsUndo) {
    window_->document().replace({});
    window_->selection().clear();
    auto* hint = qobject_cast<QLabel*>(window_->properties().groups().page(0));
    ASSERT_NE(hint, nullptr);
    const auto says_empty = [hint] {
        return hint->text().startsWith(QStringLiteral("The project is empty"));
    };
    EXPECT_TRUE(says_empty());
    add_analysis(window_->document(), "measurement-equation");
    EXPECT_FALSE(says_empty());
    window_->document().undo();
    EXPECT_TRUE(says_empty());
    window_->document().undo_stack().redo();
    EXPECT_FALSE(says_empty());
}

TEST_F(DocumentSession, TitleAndNotesAreEditedInThePageOfTheProject) {
    open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"));
    wait_until_idle();
    const auto before = window_->selection().analysis();
    go_to_project(QStringLiteral("Project"));
    EXPECT_EQ(window_->selection().analysis(), before) << "results stay in view";
    EXPECT_EQ(field<QLineEdit>("entry_name")->text(), to_qt(project().title));
    type_into("entry_name", QStringLiteral("Hall 3"));
    EXPECT_EQ(project().title, "Hall 3");
    EXPECT_EQ(window_->project_pane().currentIndex().data().toString(), "Hall 3");
    auto* notes = field<QPlainTextEdit>("entry_notes");
    notes->setFocus();
    notes->moveCursor(QTextCursor::End);
    QTest::keyClicks(notes, QStringLiteral("!"));
    EXPECT_EQ(project().notes.back(), '!');
    trigger(QStringLiteral("Undo Change notes of the project"));
    EXPECT_NE(project().notes.back(), '!');
    EXPECT_FALSE(action(QStringLiteral("Delete"))->isEnabled()) << "a project has itself";
    EXPECT_TRUE(action(QStringLiteral("Rename"))->isEnabled());
    wait_until_idle();
    EXPECT_TRUE(status().is_current()) << "a title makes no result out of date";
}

TEST_F(DocumentSession, TheListOfStepsLeadsBackAndForth) {
    open(project_copy());
    Document& document = window_->document();
    for (const char* title : {"one", "two", "three"}) {
        document.apply(QStringLiteral("Title & ") + QLatin1String(title),
                       [title](Project& project) { project.title = title; });
    }
    QMenu* list = action(QStringLiteral("Undo List"))->menu();
    ASSERT_TRUE(list);
    const auto choose_step = [list](int at) {
        emit list->aboutToShow();
        list->actions().at(at)->trigger();
    };
    emit list->aboutToShow();
    ASSERT_EQ(list->actions().size(), 4);
    EXPECT_EQ(list->actions().at(0)->text(), QStringLiteral("Title && three"));
    EXPECT_TRUE(list->actions().at(0)->isChecked());
    choose_step(2);
    EXPECT_EQ(document.project().title, "one");
    choose_step(3);
    EXPECT_FALSE(document.is_modified()) << "as it was opened";
    choose_step(1);
    EXPECT_EQ(document.project().title, "two");
    emit list->aboutToShow();
    EXPECT_TRUE(list->actions().at(1)->isChecked());
    EXPECT_FALSE(list->actions().at(0)->isChecked()) << "it can be done again";
}

TEST_F(DocumentSession, TheWindowsCertificateIsThatOfTheCommandLine) {
    open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"));
    wait_until_idle();
    ASSERT_NO_FATAL_FAILURE(fill_certificate());
    EXPECT_TRUE(missing_in(*MadeProject::make(project()), certified_ids(project())).items().empty());
    EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
    const QString ours = folder_.filePath(QStringLiteral("ours.pdf"));
    answer_.file_to_save = ours;
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    trigger(QStringLiteral("Certificate as PDF"));
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    EXPECT_EQ(finished[0][1].toString(), QString());
    answer_.file_to_save = folder_.filePath(QStringLiteral("saved.covaria"));
    trigger(QStringLiteral("Save As"));
    const QString theirs = folder_.filePath(QStringLiteral("theirs.pdf"));
    run_program({QStringLiteral("report"), answer_.file_to_save, QStringLiteral("--certificate"),
                 QStringLiteral("-o"), theirs});
    expect_same_pdf(ours, theirs);

    auto* report = window_->results().findChild<ReportPreview*>();
    window_->results().stage().show_view(report);
    ASSERT_TRUE(wait_for([&] { return report->page_count() > 0; }, 120'000));
    const std::size_t pages_of_report = report->page_count();
    choose_in(*report->findChild<QComboBox*>(QStringLiteral("document_kind")), QStringLiteral("Certificate"));
    EXPECT_EQ(report->page_count(), 0U) << "no page of the report stays";
    ASSERT_TRUE(wait_for([&] { return report->page_count() > 0; }, 120'000));
    EXPECT_LE(report->page_count(), 3U);
    EXPECT_LT(report->page_count(), pages_of_report);
    for (const auto& [width, height] : {std::pair(1280, 800), std::pair(1920, 1080)})
        for (const char* theme : {"light", "dark"}) {
            window_->findChild<ThemeSwitch*>()->choose(QString::fromLatin1(theme));
            window_->resize(width, height);
            shoot(QStringLiteral("certificate-%1-%2").arg(width).arg(QString::fromLatin1(theme)));
        }
}

TEST_F(DocumentSession, WhatIsMissingIsNamedBeforeTheExport) {
    open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"));
    wait_until_idle();
    QString asked;
    window_->files().dialogs.confirm = [&](const QString& question, const QString&) {
        asked = question;
        return false;
    };
    trigger(QStringLiteral("Certificate as PDF"));
    for (const CertificateField& one : certificate_fields())
        EXPECT_EQ(asked.contains(QStringLiteral("%1 (%2)").arg(QString::fromLatin1(one.title),
                                                               QString::fromLatin1(one.clause))),
                  one.required || one.required_for_conformity)  // h1 has a tolerance
            << one.title << "\n"
            << asked.toStdString();
    EXPECT_EQ(window_->selection().entry(), project_address) << "where it is stated";
    EXPECT_TRUE(window_->properties().groups().is_open(1));
    shoot(QStringLiteral("certificate-form-empty"));
}

TEST_F(DocumentSession, AnExportWaitsForTheResultsAndTheTextsOfNow) {
    open(QStringLiteral(COVARIA_SOURCE_DIR "/projects/gum/h1-end-gauge.covaria"));
    wait_until_idle();
    go_to_project(QStringLiteral("Certificate"));
    type_into("/certificate/number", QStringLiteral("N-77"));
    const QString file = folder_.filePath(QStringLiteral("now.pdf"));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    window_->exports().export_document_to(file, DocumentKind::certificate);
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    QProcess process;
    process.start(QStringLiteral("pdftotext"), {file, QStringLiteral("-")});
    ASSERT_TRUE(process.waitForFinished(60'000));
    const QString text = QString::fromUtf8(process.readAllStandardOutput());
    EXPECT_TRUE(text.contains(QStringLiteral("N-77"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("not stated"))) << text.toStdString();
}

TEST_F(DocumentSession, TheReportHasWhatThePageOfTheProjectSays) {
    open(project_copy());
    wait_until_idle();
    go_to_project(QStringLiteral("Report"));
    shoot(QStringLiteral("report-form"));
    for (const char* name : {"report:from-artefacts", "report:scene"})
        QTest::mouseClick(field<QCheckBox>(name), Qt::LeftButton, {}, QPoint(8, 8));
    EXPECT_EQ(project().report, (ReportContents{{"from-artefacts"}, {"scene"}, false}));
    const QString ours = folder_.filePath(QStringLiteral("ours.pdf"));
    QSignalSpy finished(&window_->exports(), &ExportActions::finished);
    window_->exports().export_document_to(ours, DocumentKind::report, ReportFormat::pdf);
    ASSERT_TRUE(wait_for([&] { return !finished.empty(); }, 120'000));
    answer_.file_to_save = folder_.filePath(QStringLiteral("saved.covaria"));
    trigger(QStringLiteral("Save As"));
    const QString theirs = folder_.filePath(QStringLiteral("theirs.pdf"));
    run_program({QStringLiteral("report"), answer_.file_to_save, QStringLiteral("-o"), theirs});
    expect_same_pdf(ours, theirs);
}

}  // namespace
}  // namespace covaria::ui::document_session_test
