// The life of the project's file: broken files, folders that cannot be written, leaving, crashes, other
// programs.
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QProcess>
#include <QSignalSpy>

#include "tests/ui/main_window/session_fixture.h"

namespace covaria::ui::file_session_test {
namespace {

std::string content(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll().toStdString();
}

void write(const QString& name, const std::string& text) {
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly)) << name.toStdString();
    file.write(text.data(), qint64(text.size()));
}

class FileSession : public Session {
protected:
    void edit() { type_into("base_u_x", QStringLiteral("0.08 mm")); }
    /// Opens `text` as a file; it must be refused in words that say `said`.
    void expect_refused(const std::string& text, const QString& said) {
        const std::string before = bytes();
        const QString broken = folder_.filePath(QStringLiteral("broken.covaria"));
        write(broken, text);
        answer_.messages.clear();
        open(broken);
        ASSERT_EQ(answer_.messages.size(), 1);
        EXPECT_TRUE(answer_.messages[0].contains(QStringLiteral("broken.covaria")));
        EXPECT_TRUE(answer_.messages[0].contains(said)) << answer_.messages[0].toStdString();
        EXPECT_EQ(bytes(), before);
    }
    QStringList recovery_files() const {
        return QDir(folder_.filePath(QStringLiteral("recovery")))
            .entryList({QStringLiteral("*.recovery")}, QDir::Files);
    }
    void drop(const QStringList& names) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& name : names) urls << QUrl::fromLocalFile(name);
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(600, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &enter);
        if (!enter.isAccepted()) return;
        QDropEvent event(QPointF(600, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &event);
    }
};

TEST_F(FileSession, BrokenFilesAreRefusedInWordsAndTheProjectStays) {
    open(project_copy());
    expect_refused("{\"format\": \"covaria\", \"schemaVersion\": 1, \"title\": \"x\", \"assets\": [",
                   QStringLiteral("line 1"));
    expect_refused("", QStringLiteral("broken"));
    expect_refused("PK\x03\x04 not text at all \xff\xfe", QStringLiteral("line 1"));
    expect_refused(
        "{\"format\": \"covaria\", \"schemaVersion\": 99, \"title\": \"x\", \"assets\": [], "
        "\"analyses\": []}",
        QStringLiteral("99"));
}

TEST_F(FileSession, SavingWhereNothingCanBeWrittenSaysSo) {
    open(project_copy());
    edit();
    const QString file = window_->document().file();
    QDir(folder_.path()).mkpath(QStringLiteral("taken.covaria/inside"));
    const std::pair<QString, QString> places[] = {
        {QStringLiteral("/proc/nowhere/project.covaria"), QStringLiteral("/proc/nowhere")},
        {folder_.filePath(QStringLiteral("taken.covaria")), QStringLiteral("taken.covaria")}};
    for (const auto& [place, named] : places) {
        answer_.messages.clear();
        answer_.file_to_save = place;
        trigger(QStringLiteral("Save As"));
        ASSERT_EQ(answer_.messages.size(), 1) << place.toStdString();
        EXPECT_TRUE(answer_.messages[0].contains(named)) << answer_.messages[0].toStdString();
        EXPECT_TRUE(window_->document().is_modified());
        EXPECT_EQ(window_->document().file(), file) << "the project keeps its name";
    }
}

TEST_F(FileSession, ClosingWithUnsavedChangesAsks) {
    const QString file = project_copy();
    open(file);
    const std::string saved = content(file);
    edit();
    answer_.save = SaveAnswer::cancel;
    EXPECT_FALSE(window_->close());
    EXPECT_EQ(answer_.save_questions, 1);
    EXPECT_TRUE(window_->isVisible());
    EXPECT_EQ(content(file), saved);
    answer_.save = SaveAnswer::save;
    EXPECT_TRUE(window_->close());
    EXPECT_EQ(content(file), bytes());
    EXPECT_NE(content(file), saved);
}

TEST_F(FileSession, DiscardedChangesLeaveTheFileAndNothingToRecover) {
    const QString file = project_copy();
    open(file);
    const std::string saved = content(file);
    edit();
    ASSERT_TRUE(wait_for([this] { return recovery_files().size() == 1; })) << "autosave";
    answer_.save = SaveAnswer::discard;
    EXPECT_TRUE(window_->close());
    window_.reset();
    EXPECT_EQ(content(file), saved);
    EXPECT_TRUE(recovery_files().isEmpty());
    make_window();
}

TEST_F(FileSession, WhatIsTypedCountsWithoutEnter) {
    const QString file = project_copy();
    open(file);
    auto* field = this->field<QLineEdit>("base_u_x");
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.125 mm"));
    QTest::keySequence(field, QKeySequence::Save);
    EXPECT_TRUE(content(file).find("0.125") != std::string::npos);
    EXPECT_TRUE(field->hasFocus());
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.25 mm"));
    answer_.save = SaveAnswer::cancel;
    EXPECT_FALSE(window_->close());
    EXPECT_EQ(answer_.save_questions, 1);
}

TEST_F(FileSession, WorkOfAKilledWindowIsRecovered) {
    const QString file = project_copy();
    const std::string saved = content(file);
    QProcess child;
    child.setProcessChannelMode(QProcess::MergedChannels);
    child.start(QStringLiteral(COVARIA_CRASHING_WINDOW),
                {file, folder_.filePath(QStringLiteral("recovery"))});
    ASSERT_TRUE(child.waitForFinished(60'000));
    ASSERT_EQ(child.exitStatus(), QProcess::CrashExit)
        << child.exitCode() << child.readAllStandardOutput().toStdString();
    EXPECT_EQ(content(file), saved) << "the file is as it was";

    QStringList offered;
    window_->files().dialogs.recover = [&](const QStringList& entries) {
        offered = entries;
        return RecoverAnswer{RecoverAnswer::What::later};
    };
    window_->begin({});
    ASSERT_EQ(offered.size(), 1);
    EXPECT_FALSE(window_->document().is_modified());
    EXPECT_EQ(recovery_files().size(), 1) << "later: it is kept";
    window_->files().dialogs.recover = [](const QStringList&) {
        return RecoverAnswer{RecoverAnswer::What::recover};
    };
    window_->begin({});
    EXPECT_TRUE(window_->document().is_modified());
    EXPECT_TRUE(window_->isWindowModified());
    EXPECT_EQ(field<QLineEdit>("base_u_x")->text(), QStringLiteral("0.123 mm"));
    EXPECT_EQ(window_->document().file(), file);
    trigger(QStringLiteral("Save"));
    EXPECT_EQ(content(file), bytes());
    EXPECT_TRUE(recovery_files().isEmpty()) << "recovered once, not again";
}

TEST_F(FileSession, AFileChangedByAnotherProgramIsReadAgainOrKept) {
    const QString file = project_copy();
    open(file);
    const std::string saved = content(file);
    int asked = 0;
    window_->files().dialogs.changed_on_disk = [&](const QString&, bool modified) {
        ++asked;
        EXPECT_FALSE(modified);
        return answer_.disk;
    };
    std::string other = saved;
    other.replace(other.find("\"title\": \""), 10, "\"title\": \"Other ");
    answer_.disk = DiskAnswer::keep;
    write(file, other);
    ASSERT_TRUE(wait_for([&] { return asked == 1; }));
    EXPECT_EQ(bytes(), saved);
    EXPECT_TRUE(window_->document().is_modified()) << "kept, but no longer what the file says";
    trigger(QStringLiteral("Save"));
    EXPECT_EQ(content(file), saved);

    answer_.disk = DiskAnswer::reload;
    write(file, other);
    ASSERT_TRUE(wait_for([&] { return bytes() == other; }));
    EXPECT_EQ(asked, 2);
    EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(FileSession, AProjectDroppedOnTheWindowOpens) {
    const QString file = project_copy();
    write(folder_.filePath(QStringLiteral("notes.txt")), "no project");
    QSignalSpy opened(&window_->document(), &Document::open_finished);
    drop({folder_.filePath(QStringLiteral("notes.txt")), file});
    ASSERT_TRUE(opened.wait(10'000));
    EXPECT_EQ(opened.size(), 1);
    EXPECT_EQ(window_->document().file(), file);
    EXPECT_TRUE(answer_.messages.isEmpty());
}

}  // namespace
}  // namespace covaria::ui::file_session_test
