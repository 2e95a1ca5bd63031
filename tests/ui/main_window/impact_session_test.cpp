// A user asks what hangs on a certificate: the years of an invented gauge block, of which the calibration of
// 2025 turns out wrong by 60 nm.
#include <QCheckBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QToolButton>

#include "core/base/file_io.h"
#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/impact_form.h"
#include "ui/main_window/impact_actions.h"
#include "ui/main_window/impact_dialog.h"
#include "ui/models/roles.h"
#include "ui/pages/sortable_table.h"

namespace covaria::ui::impact_session_test {
namespace {

const QString years = QStringLiteral(COVARIA_SOURCE_DIR "/docs/three-years");

class ImpactSession : public Session {
protected:
    ImpactDialog& dialog() { return window_->impact().dialog(); }
    template <class Widget>
    Widget* part(const char* name) {
        return dialog().findChild<Widget*>(QString::fromLatin1(name));
    }
    void type(const char* name, const QString& text) {
        auto* line = part<QWidget>(name);
        line->setFocus();
        QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(line, text);
    }
    void evaluate() {
        QTest::mouseClick(part<QPushButton>("impact_evaluate"), Qt::LeftButton);
        EXPECT_TRUE(wait_for([this] { return !dialog().is_busy(); }, 120'000));
    }
    void ask(const QString& new_figures) {
        trigger(QStringLiteral("What Hangs on a Certificate"));
        ASSERT_TRUE(dialog().isVisible());
        type("impact_certificate", QStringLiteral("NI 2025-0933"));
        type("impact_figures", new_figures);
        type("impact_places", years);
        QTest::mouseClick(dialog().form().findChild<QCheckBox*>(), Qt::LeftButton, Qt::NoModifier,
                          QPoint(8, 8));
    }
    const QAbstractItemModel& table() { return *dialog().table().model(); }
    QString words(int row, const char* head) {
        for (int c = 0; c < table().columnCount(); ++c)
            if (table().headerData(c, Qt::Horizontal, id_role).toString() == QLatin1String(head))
                return table().index(row, c).data().toString();
        ADD_FAILURE() << head;
        return {};
    }
    void keep_dialog(const QString& name) {
        QCoreApplication::processEvents();
        dialog().grab().save(QStringLiteral(COVARIA_BINARY_DIR "/screenshots/%1.png").arg(name));
    }
};

TEST_F(ImpactSession, TellsWhichResultsChangeAndWritesThem) {
    ask(years + QStringLiteral("/standard/2026-as-found.covaria"));
    evaluate();
    // docs/three-years: four customers of 2025 and the project of the standard.
    EXPECT_EQ(part<QLabel>("impact_answer")->text(),
              QStringLiteral("Of 5 results 5 change, 5 of them in what is stated; verdicts that change: 1."));
    ASSERT_EQ(table().rowCount(), 5);
    EXPECT_EQ(words(0, "Verdict before"), QStringLiteral("met"));
    EXPECT_EQ(words(0, "Verdict after"), QStringLiteral("not met"));
    EXPECT_TRUE(words(0, "File").startsWith(QStringLiteral("2025/customer-"))) << to_std(words(0, "File"));
    keep_dialog(QStringLiteral("impact"));

    const auto written = [&](const QString& name, const auto& write) {
        const QString file = folder_.filePath(name);
        QSignalSpy finished(&dialog(), &ImpactDialog::finished_writing);
        write(file);
        EXPECT_TRUE(finished.count() > 0 || finished.wait(30'000)) << to_std(name);
        return read_file(to_path(file)).value_or("");
    };
    const auto choose = [&](int entry, const QString& file) {
        answer_.file_to_save = file;
        dialog().findChild<QMenu*>()->actions().at(entry)->trigger();
    };
    EXPECT_TRUE(written(QStringLiteral("impact.pdf"), [&](const QString& file) {
                    choose(0, file);
                }).starts_with("%PDF"));
    const std::string csv =
        written(QStringLiteral("impact.csv"), [&](const QString& file) { choose(2, file); });
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    const std::string list =
        written(QStringLiteral("amend.txt"), [&](const QString& file) { choose(3, file); });
    EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 5);

    // A row leads to its project.
    QSignalSpy opened(&window_->document(), &Document::open_finished);
    emit dialog().table().activated(table().index(0, 0));
    ASSERT_TRUE(opened.wait(10'000));
    EXPECT_TRUE(window_->document().file().contains(QStringLiteral("/2025/")));
}

TEST_F(ImpactSession, TellsWhoUsedACertificateWithoutNewFigures) {
    ask({});
    EXPECT_EQ(part<QPushButton>("impact_evaluate")->text(), QStringLiteral("&Find Who Used It"));
    evaluate();
    EXPECT_EQ(table().rowCount(), 5);
    EXPECT_EQ(part<QLabel>("impact_answer")->text(),
              QStringLiteral("16 projects and reports were looked at; 5 use the figures."));
    answer_.file_to_save = folder_.filePath(QStringLiteral("users.txt"));
    const QList<QAction*> saving = dialog().findChild<QMenu*>()->actions();
    EXPECT_FALSE(saving.first()->isEnabled()) << "nothing was evaluated";
    saving.last()->trigger();
    const std::string list = read_file(to_path(answer_.file_to_save)).value_or("");
    EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 5);
}

TEST_F(ImpactSession, EscapeStopsAndClosingEndsIt) {
    ask(years + QStringLiteral("/standard/2026-as-found.covaria"));
    evaluate();
    dialog().evaluate();
    EXPECT_EQ(table().rowCount(), 0) << "the results of another question";
    QTest::keyClick(&dialog(), Qt::Key_Escape);
    EXPECT_FALSE(dialog().is_busy());
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_EQ(part<QLabel>("impact_answer")->text(), QStringLiteral("Stopped."));
    dialog().evaluate();
    dialog().close();
    EXPECT_FALSE(dialog().is_busy());
    EXPECT_FALSE(dialog().isVisible());
}

TEST_F(ImpactSession, BeginsAtTheCertificateOfAnEntry) {
    open(years + QStringLiteral("/2025/customer-a.covaria"));
    select(SetupOwner::analysis, "length");
    QTest::mouseClick(field<QToolButton>("source_impact"), Qt::LeftButton);
    ASSERT_TRUE(dialog().isVisible());
    EXPECT_EQ(to_qt(dialog().form().words().old_figures), QStringLiteral("NI 2025-0933"));
    EXPECT_EQ(dialog().form().words().folders, std::vector<std::string>{to_std(years) + "/2025"});
}

TEST_F(ImpactSession, SaysWhatItCannotEvaluate) {
    ask(years + QStringLiteral("/nowhere.covaria"));
    evaluate();
    EXPECT_EQ(table().rowCount(), 0);
    EXPECT_TRUE(part<QLabel>("impact_answer")->text().contains(QStringLiteral("nowhere.covaria")))
        << to_std(part<QLabel>("impact_answer")->text());

    // A file that lost its quantities is named, and keeps nobody from the others.
    QString text = to_qt(read_file(to_path(years + QStringLiteral("/2025/customer-b.covaria"))).value_or(""));
    text.replace(QStringLiteral("l_X = l_S"), QStringLiteral("l_X = l_S + gone"));
    ASSERT_TRUE(write_file_atomically(to_path(folder_.filePath(QStringLiteral("b.covaria"))), to_std(text)));
    type("impact_figures", years + QStringLiteral("/standard/2026-as-found.covaria"));
    dialog().form().add_place(folder_.filePath(QStringLiteral("b.covaria")));
    evaluate();
    EXPECT_EQ(table().rowCount(), 5);
    auto* failures = part<QListWidget>("impact_failures");
    ASSERT_EQ(failures->count(), 1);
    EXPECT_TRUE(failures->item(0)->text().contains(QStringLiteral("b.covaria")));
    EXPECT_TRUE(failures->isVisible());
    keep_dialog(QStringLiteral("impact-failure"));
}

}  // namespace
}  // namespace covaria::ui::impact_session_test
