// The project being edited: a value, its history and its file. Every change goes through `apply`.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/made/load_project.h"
#include "core/project/project.h"
#include "ui/document/file_watch.h"
#include "ui/document/kept_project.h"
#include "ui/document/project_maker.h"
#include "ui/document/unread_texts.h"

namespace covaria::ui {

using ProjectEdit = std::function<void(Project&)>;

class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);
    /// `check`: finds the problems, in place of those of the made project.
    Document(ProjectMaker::Check check, QObject* parent);
    ~Document() override;

    const Project& project() const { return *project_; }
    /// The present value; stays as it is whatever is edited later (for worker threads).
    ProjectSnapshot snapshot() const { return project_; }

    /// Copies the project, edits the copy, and if it differs pushes one undo step. Edits with the same
    /// `merge_key` (not empty) that follow each other closely become one step: drags and typing.
    /// Returns whether the project changed. From a slot of `project_changed` (a field that loses its focus
    /// with the entry it is of): a step of its own, once the present one is done.
    bool apply(const QString& text, const ProjectEdit& edit, const QString& merge_key = {});
    /// The next edit starts a new undo step whatever its key; those of one key from then on are one step,
    /// however long they pause (a drag), until `end_merging`.
    void begin_merging();
    void end_merging();
    /// Longest pause between two edits that merge, in milliseconds.
    void set_merge_window(int milliseconds) { merge_window_ = milliseconds; }

    QUndoStack& undo_stack() { return undo_stack_; }
    /// Takes back texts that cannot be read and were typed since the last step, else that step with those
    /// that came with it.
    void undo();
    bool can_undo() const;
    /// Undoes or does again until `index` steps are done (`undo_stack().index()`).
    void go_to_step(int index);
    bool is_modified() const { return unsaved_ || !undo_stack_.isClean(); }

    /// The file on disk is no longer this project: it counts as unsaved whatever its history says.
    void set_unsaved();

    const QString& file() const { return file_; }  ///< empty: never saved
    /// The file's name without folder and ending, or the title, or "Untitled".
    QString display_name() const;
    /// The display name, and the report that the project was taken out of, until it is saved.
    QString heading() const;

    /// Puts another project in the place of this one; history and file are forgotten.
    void replace(Project project);
    void replace_by(const LoadedProject& loaded);
    /// A project read from a recovery file: like `open`, but unsaved.
    void restore(const LoadedProject& loaded, const QString& original_file);
    /// Reads a file; of a report (PDF) the project that it carries, which is unsaved then. What is returned
    /// says why it could not be read; the document stays as it was then. A project that only lacks something
    /// is opened, and lacks it.
    Problems open(const QString& file);
    /// The same with the reading done in a worker thread; ends with `open_finished`. The latest call wins.
    void open_in_background(const QString& file);
    /// Error{cancelled}: somebody has changed the file since it was read; `save_as` its name replaces it.
    Result<void> save();
    /// CSV files the project refers to are copied beside the new file where they are not there yet.
    Result<void> save_as(const QString& file);

    /// Problems of the project and of the texts that cannot be read.
    const Problems& problems() const { return problems_; }
    /// Texts typed into fields and cells that cannot be read: not part of the project.
    UnreadTexts& unread() { return unread_; }
    const UnreadTexts& unread() const { return unread_; }
    /// Makes the project after every change, in a worker thread: who reads what is made follows it.
    ProjectMaker& maker() { return maker_; }
    /// Makes and checks at once instead.
    void check_now() { maker_.make_now(project_); }

signals:
    void project_changed();
    /// Another project is open: emitted before `project_changed`.
    void project_replaced();
    void problems_changed();
    void modified_changed(bool modified);
    void file_changed();
    void open_finished(const QString& file, const covaria::Problems& problems);
    /// Another program wrote or removed the file.
    void changed_on_disk();

private:
    friend class ProjectCommand;
    void set_project(ProjectSnapshot project, KeptProject::Pointer kept);
    /// Sets a project of the history.
    void set_project(const KeptProject::Pointer& kept) {
        set_project(std::make_shared<const Project>(kept->project()), kept);
    }
    void connect_parts();
    void adopt(ProjectSnapshot project, const QString& file, const MadeProject::Pointer& made);
    void take_made();
    void set_file(const QString& file);
    void adopt_opened(const QString& file, const LoadedProject& loaded);
    void finish_open(const QString& file, const LoadedProject& loaded);
    void collect_problems();

    void push(const QString& text, ProjectSnapshot after, const QString& merge_key);
    void push_waiting();

    ProjectSnapshot project_ = std::make_shared<const Project>();
    KeptProject::Pointer kept_ = KeptProject::keep({}, nullptr);  ///< `project_`, for the history
    bool changing_ = false;                                       ///< `project_changed` is being heard
    struct Waiting {
        QString text, merge_key;
        ProjectSnapshot after;
    };
    std::optional<Waiting> waiting_;  ///< the step after the present one
    QUndoStack undo_stack_;
    ProjectMaker maker_;
    UnreadTexts unread_;
    Problems of_made_;  ///< problems of the made project, as long as that is the present one
    Problems problems_;
    FileWatch watch_;
    QString file_;
    QString report_;        ///< the report that the project was taken out of; empty: none
    bool unsaved_ = false;  ///< recovered, or the file differs
    int merge_window_ = 2000;
    int merge_series_ = 0;
    bool is_merging_ = false;
    LatestJob open_job_{Execution::threads};  ///< last member: its thread ends first
};

}  // namespace covaria::ui
