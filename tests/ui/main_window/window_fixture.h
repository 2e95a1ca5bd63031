// A window with scripted answers to its questions, settings and recovery files of its own.
#pragma once

#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "core/made/load_project.h"
#include "core/project/project_file.h"
#include "tests/ui/qt_application.h"
#include "ui/main_window/main_window.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

class WindowFixture : public testing::Test {
protected:
    WindowFixture() {
        QCoreApplication::setOrganizationName(QStringLiteral("CovariaTest"));
        QCoreApplication::setApplicationName(QStringLiteral("CovariaTest"));
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        QSettings().clear();
        make_window();
    }
    ~WindowFixture() override {
        answer_.save = SaveAnswer::discard;
        window_->close();
    }

    struct Answers {
        SaveAnswer save = SaveAnswer::discard;
        DiskAnswer disk = DiskAnswer::keep;
        QString file_to_save, file_to_import;
        RecoverAnswer recover = {};
        bool confirm = true;
        QStringList messages;  ///< shown to the user
        int save_questions = 0;
    };

    void make_window() {
        window_ = std::make_unique<MainWindow>(RecoveryStore(folder_.filePath(QStringLiteral("recovery"))));
        Dialogs& dialogs = window_->files().dialogs;
        dialogs.save_changes = [this](const QString&) {
            ++answer_.save_questions;
            return answer_.save;
        };
        dialogs.changed_on_disk = [this](const QString&, bool) { return answer_.disk; };
        dialogs.file_to_save = [this](const QString&, const QString&, const QString&) {
            return answer_.file_to_save;
        };
        dialogs.file_to_import = [this](const QString&, const QString&, const QString&) {
            return answer_.file_to_import;
        };
        dialogs.recover = [this](const QStringList&) { return answer_.recover; };
        dialogs.confirm = [this](const QString&, const QString&) { return answer_.confirm; };
        dialogs.show_message = [this](const QString& title, const QString& message) {
            answer_.messages << title + QLatin1Char('\n') + message;
        };
        window_->resize(1280, 800);
        window_->show();
    }

    /// A copy of a shipped project (with its CSV files) that tests may change, with few trials.
    QString project_copy(const QString& name = QStringLiteral("stewart-platform")) {
        const QDir projects(QStringLiteral(COVARIA_SOURCE_DIR "/projects"));
        for (const QFileInfo& file : projects.entryInfoList({name + QLatin1Char('*')}, QDir::Files)) {
            QFile::remove(folder_.filePath(file.fileName()));
            QFile::copy(file.absoluteFilePath(), folder_.filePath(file.fileName()));
        }
        const QString copy = folder_.filePath(name + QStringLiteral(".covaria"));
        Project project = load_project(to_path(copy)).project;
        for (AnalysisEntry& analysis : project.analyses) analysis.options.trials = 20'000;
        EXPECT_TRUE(save_project(project, to_path(copy)));
        return copy;
    }

    void open(const QString& file) {
        QSignalSpy opened(&window_->document(), &Document::open_finished);
        window_->files().open_file(file);
        ASSERT_TRUE(opened.wait(10'000));
    }

    void wait_until_idle() { ASSERT_TRUE(window_->runner().wait_until_idle(60'000)); }

    /// Everything that goes on by itself is over and has been painted.
    void settle() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !window_->scene().is_building(); }, 30'000));
        window_->scene().view().service().wait_until_idle();
        for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
    }

    std::string bytes() const { return project_text(window_->document().project()); }

    QTemporaryDir folder_;
    Answers answer_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace covaria::ui
