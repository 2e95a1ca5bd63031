// Opening, saving, other programs' changes, autosave and recovery after a crash.
#include <gtest/gtest.h>

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QProcess>
#include <QTemporaryDir>
#include <csignal>
#include <filesystem>

#include "core/kinds/registries.h"
#include "core/pdf/pdf_archive.h"
#include "core/project/linked_files.h"
#include "core/project/project_file.h"
#include "tests/ui/qt_application.h"
#include "ui/document/autosave.h"
#include "ui/document/copy_linked_files.h"
#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/document/project_edits.h"
#include "ui/document/recovery_store.h"
#include "ui/theme/strings.h"

namespace covaria::ui::document_file_test {
namespace {

struct DocumentFileTest : testing::Test {
    QString path(const QString& name) const { return folder.filePath(name); }
    QByteArray bytes(const QString& name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void write(const QString& name, const QByteArray& content) const {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    void set_title(const std::string& title) {
        document.apply("Change title", [&](Project& project) { project.title = title; });
    }
    QTemporaryDir folder;
    Document document;
};

TEST_F(DocumentFileTest, SavesOpensAndUndoesToTheSameBytes) {
    set_title("Platform");
    ASSERT_TRUE(document.save_as(path("p.covaria")));
    EXPECT_FALSE(document.is_modified());
    const QByteArray saved = bytes("p.covaria");
    ASSERT_FALSE(saved.isEmpty());

    Document other;
    ASSERT_FALSE(other.open(path("p.covaria")).has_errors());
    EXPECT_EQ(other.project().title, "Platform");
    EXPECT_EQ(other.display_name(), "p");
    for (int i = 0; i < 50; ++i)
        other.apply("Notes", [i](Project& project) { project.notes = "note " + std::to_string(i); });
    ASSERT_TRUE(other.save());
    EXPECT_NE(bytes("p.covaria"), saved);
    while (other.undo_stack().canUndo()) other.undo_stack().undo();
    EXPECT_TRUE(other.is_modified());
    ASSERT_TRUE(other.save());
    EXPECT_EQ(bytes("p.covaria"), saved);
}

TEST_F(DocumentFileTest, ABrokenFileLeavesTheDocumentAlone) {
    set_title("kept");
    write("broken.covaria", "{\"format\": \"covaria\", ");
    EXPECT_TRUE(document.open(path("broken.covaria")).has_errors());
    EXPECT_TRUE(document.open(path("missing.covaria")).has_errors());
    EXPECT_EQ(document.project().title, "kept");
    EXPECT_TRUE(document.file().isEmpty());
}

/// Whatever can be saved can be opened, as it was.
TEST_F(DocumentFileTest, WorkThatIsNotDoneIsOpenedAsItWasSaved) {
    const auto expect_back = [&](Project project, const std::string& what) {
        project.directory.clear();
        document.replace(std::move(project));
        ASSERT_TRUE(document.save_as(path("unfinished.covaria"))) << what;
        Document other;
        const Problems refused = other.open(path("unfinished.covaria"));
        EXPECT_FALSE(refused.has_errors()) << what << ": " << first_error(refused, "");
        EXPECT_EQ(project_text(other.project()), project_text(document.project())) << what;
    };
    for (const ModelDescriptor& model : model_registry()) {
        document.replace({});
        ASSERT_FALSE(add_analysis(document, model.id).empty());
        expect_back(document.project(), "nothing of " + model.id);
    }
    for (const char* examples : {"/projects", "/projects/gum"})
        for (const QFileInfo& file : QDir(QStringLiteral(COVARIA_SOURCE_DIR) + QLatin1String(examples))
                                         .entryInfoList({QStringLiteral("*.covaria")}, QDir::Files)) {
            Document example;
            ASSERT_FALSE(example.open(file.filePath()).has_errors());
            Project whole = example.project();
            unlink_tables(whole);
            for (const AssetEntry& asset : whole.assets) {
                document.replace(whole);
                remove(document, {SetupOwner::asset, asset.id});
                expect_back(document.project(), to_std(file.fileName()) + " without " + asset.id);
            }
            for (const AnalysisEntry& analysis : whole.analyses) {
                document.replace(whole);
                remove(document, {SetupOwner::analysis, analysis.id});
                expect_back(document.project(), to_std(file.fileName()) + " without " + analysis.id);
            }
        }
}

TEST_F(DocumentFileTest, OpensInTheBackgroundAndTheLatestWins) {
    set_title("one");
    ASSERT_TRUE(document.save_as(path("1.covaria")));
    set_title("two");
    ASSERT_TRUE(document.save_as(path("2.covaria")));
    Document other;
    QSignalSpy finished(&other, &Document::open_finished);
    other.open_in_background(path("1.covaria"));
    other.open_in_background(path("2.covaria"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return finished.count() > 0; }));
    EXPECT_EQ(finished.count(), 1) << "files are read one after the other: the first is done, too";
    EXPECT_EQ(other.project().title, "two");
}

TEST_F(DocumentFileTest, SavingWhereItCannotBeWrittenIsAnError) {
    set_title("x");
    EXPECT_FALSE(document.save()) << "no name yet";
    const auto saved = document.save_as(path("no such folder/p.covaria"));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::io);
    EXPECT_TRUE(document.is_modified());
    EXPECT_TRUE(document.file().isEmpty());
}

TEST_F(DocumentFileTest, OtherProgramsChangesAreNoticedOwnOnesAreNot) {
    set_title("x");
    ASSERT_TRUE(document.save_as(path("p.covaria")));
    QSignalSpy changed(&document, &Document::changed_on_disk);
    set_title("y");
    ASSERT_TRUE(document.save());
    write("p.covaria", "something else");
    EXPECT_TRUE(QTest::qWaitFor([&] { return changed.count() > 0; }));
    EXPECT_EQ(changed.count(), 1) << "the own change was not told";
    QFile::remove(path("p.covaria"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return changed.count() >= 2; }));
}

// A watcher of files may be told of nothing: before saving, the file is compared with what was read.
TEST_F(DocumentFileTest, WhatAnotherProgramHasWrittenIsNotReplacedUnasked) {
    set_title("x");
    ASSERT_TRUE(document.save_as(path("p.covaria")));
    set_title("y");
    write("p.covaria", "something else");
    const auto saved = document.save();  // before any event
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::cancelled);
    EXPECT_EQ(bytes("p.covaria"), "something else");
    ASSERT_TRUE(document.save_as(path("p.covaria"))) << "who says so replaces it";
    EXPECT_NE(bytes("p.covaria"), "something else");
    set_title("z");
    EXPECT_TRUE(document.save()) << "and it is this program's again";
}

// Between the reading of a file and the beginning of the watch.
TEST_F(DocumentFileTest, WhatIsWrittenWhileItIsOpenedIsNoticed) {
    write("p.covaria", "as read");
    const QByteArray read = FileWatch::content_of(path("p.covaria"));
    FileWatch watch;
    QSignalSpy changed(&watch, &FileWatch::changed);
    watch.watch(path("p.covaria"));
    watch.was_read_as(read);
    EXPECT_EQ(changed.count(), 0);
    write("p.covaria", "something else");
    FileWatch late;
    QSignalSpy changed_late(&late, &FileWatch::changed);
    late.watch(path("p.covaria"));
    late.was_read_as(read);
    EXPECT_EQ(changed_late.count(), 1);
}

/// Permissions of a file, as chmod takes them.
unsigned mode_of(const QString& file) {
    return static_cast<unsigned>(std::filesystem::status(to_path(file)).permissions());
}

TEST_F(DocumentFileTest, NobodyReadsTheRecoveryFileWhoMayNotReadTheProject) {
    Project project;
    project.title = "secret";
    const QString recovery = path("recovery/a.recovery");
    ASSERT_TRUE(RecoveryStore::write(recovery, project, {}));
    EXPECT_EQ(mode_of(recovery), 0600u) << "a project without a file is its user's";
    write("p.covaria", "{}");
    for (const unsigned mode : {0600u, 0640u, 0644u}) {
        std::filesystem::permissions(to_path(path("p.covaria")), std::filesystem::perms(mode));
        ASSERT_TRUE(RecoveryStore::write(recovery, project, path("p.covaria")));
        EXPECT_EQ(mode_of(recovery), mode);
    }
}

TEST_F(DocumentFileTest, AReportOpensAsAnUnsavedProjectThatNamesIt) {
    QBuffer page;
    page.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&page);
        QPainter(&writer).drawLine(0, 0, 100, 100);
    }
    Project project;
    project.title = "Carried";
    const auto report = archived_pdf(page.data().toStdString(), {"t", "c"},
                                     {{"project.covaria", project_text(project), "application/json"}});
    ASSERT_TRUE(report) << report.error().message.english();
    write("Report 7.PDF", QByteArray::fromStdString(*report));
    write("none.pdf", page.data());
    EXPECT_TRUE(document.open(path("none.pdf")).has_errors());
    EXPECT_EQ(document.heading(), document.display_name());
    QSignalSpy finished(&document, &Document::open_finished);
    document.open_in_background(path("Report 7.PDF"));
    ASSERT_TRUE(finished.wait());
    EXPECT_EQ(document.project().title, "Carried");
    EXPECT_TRUE(document.is_modified());
    EXPECT_TRUE(document.file().isEmpty()) << "the report is never written to";
    EXPECT_EQ(document.heading(), "Carried (from Report 7.PDF)");
    ASSERT_TRUE(document.save_as(path("again.covaria")));
    EXPECT_EQ(document.heading(), "again");
    EXPECT_FALSE(document.is_modified());
    EXPECT_EQ(bytes("Report 7.PDF").toStdString(), *report);
}

TEST_F(DocumentFileTest, LinkedFilesGoAlong) {
    Project project;
    project.directory = to_path(folder.path());
    SetupTable table;
    table.csv_file = "data/points.csv";
    project.assets.push_back({"a", "kind", "A", {}, {{{"points", table}}}});
    EXPECT_EQ(linked_files(project), std::vector<std::string>{"data/points.csv"});
    ASSERT_TRUE(QDir(folder.path()).mkpath("data"));
    ASSERT_TRUE(QDir(folder.path()).mkpath("other"));
    write("data/points.csv", "1;2");
    ASSERT_TRUE(copy_linked_files(project, to_path(path("other"))));
    EXPECT_EQ(bytes("other/data/points.csv"), "1;2");
    QFile::remove(path("data/points.csv"));
    QFile::remove(path("other/data/points.csv"));
    const auto copied = copy_linked_files(project, to_path(path("other")));
    ASSERT_FALSE(copied);
    EXPECT_NE(copied.error().message.english().find("data/points.csv"), std::string::npos);
}

TEST_F(DocumentFileTest, MeshesOfTheSceneGoAlongWhereTheyAreThere) {
    Project project;
    project.directory = to_path(folder.path());
    for (const char* file : {"data/cell.stl", "data/none.stl"})
        project.assets.push_back({file, "context-mesh", "A", {}, {{{"file", std::string(file)}}}});
    ASSERT_TRUE(QDir(folder.path()).mkpath("data"));
    ASSERT_TRUE(QDir(folder.path()).mkpath("other"));
    write("data/cell.stl", "solid");
    ASSERT_TRUE(copy_linked_files(project, to_path(path("other")))) << "one that is missing is no obstacle";
    EXPECT_EQ(bytes("other/data/cell.stl"), "solid");
    EXPECT_FALSE(QFile::exists(path("other/data/none.stl")));
}

TEST_F(DocumentFileTest, ACleanEndLeavesNothingToRecover) {
    const RecoveryStore store(path("recovery"));
    {
        Autosave autosave(document, store);
        set_title("unsaved");
        autosave.flush();
        EXPECT_TRUE(QFile::exists(autosave.recovery_file()));
        EXPECT_TRUE(store.abandoned().empty()) << "its window is still open";
        ASSERT_TRUE(document.save_as(path("p.covaria")));
        EXPECT_FALSE(QFile::exists(autosave.recovery_file()));
        set_title("again");
        autosave.flush();
    }
    EXPECT_TRUE(QDir(store.folder()).entryList(QDir::Files).isEmpty());
}

TEST_F(DocumentFileTest, AutosaveWritesByItself) {
    Autosave autosave(document, RecoveryStore(path("recovery")));
    autosave.set_delay(1);
    set_title("unsaved");
    EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(autosave.recovery_file()); }));
}

/// No test of its own: the program that crashes in the next one.
TEST_F(DocumentFileTest, DISABLED_Crash) {
    Autosave autosave(document, RecoveryStore(qEnvironmentVariable("COVARIA_TEST_RECOVERY")));
    set_title("unsaved work");
    autosave.flush();
    std::raise(SIGKILL);
}

TEST_F(DocumentFileTest, RecoversAfterACrash) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("COVARIA_TEST_RECOVERY", path("recovery"));
    process.setProcessEnvironment(environment);
    process.start(QCoreApplication::applicationFilePath(),
                  {"--gtest_also_run_disabled_tests", "--gtest_filter=DocumentFileTest.DISABLED_Crash"});
    ASSERT_TRUE(process.waitForFinished());
    ASSERT_EQ(process.exitStatus(), QProcess::CrashExit);

    const RecoveryStore store(path("recovery"));
    const std::vector<RecoveryEntry> entries = store.abandoned();
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries[0].title, "unsaved work");
    const LoadedProject loaded = RecoveryStore::load(entries[0]);
    ASSERT_FALSE(loaded.problems.has_errors());
    document.restore(loaded, entries[0].original_file);
    EXPECT_EQ(document.project().title, "unsaved work");
    EXPECT_TRUE(document.is_modified());
    RecoveryStore::remove(entries[0].recovery_file);
    EXPECT_TRUE(store.abandoned().empty());
}

}  // namespace
}  // namespace covaria::ui::document_file_test
