// Editing, opening and saving.
#include "ui/document/document.h"

#include <QFileInfo>
#include <limits>
#include <utility>

#include "core/carried/carried_project.h"
#include "ui/document/copy_linked_files.h"
#include "ui/document/project_command.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

/// A step keeps the one asset or analysis that it changed (KeptProject).
constexpr int most_undo_steps = 500;

std::filesystem::path folder_of(const QString& file) {
    return file.isEmpty() ? std::filesystem::path{}
                          : project_folder(to_path(QFileInfo(file).absoluteFilePath()));
}

/// Numbers for texts that cannot be read: they came with a step of the history, or after it.
int with_step(int index) {
    return 2 * index;
}
int after_step(int index) {
    return 2 * index + 1;
}

bool is_report(const QString& file) {
    return file.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive);
}

/// Work that is not done has errors, and is opened.
Problems refusal(const LoadedProject& loaded) {
    return loaded.is_whole ? Problems() : loaded.problems;
}

LoadedProject load_file(const QString& file) {
    return is_report(file) ? load_carried(to_path(file)) : load_project(to_path(file));
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent), maker_(Execution::threads, nullptr) {
    connect_parts();
}

Document::Document(ProjectMaker::Check check, QObject* parent)
    : QObject(parent), maker_(std::move(check), Execution::threads, nullptr) {
    connect_parts();
}

void Document::connect_parts() {
    undo_stack_.setUndoLimit(most_undo_steps);
    connect(&maker_, &ProjectMaker::made_changed, this, &Document::take_made);
    connect(&unread_, &UnreadTexts::changed, this, &Document::collect_problems);
    connect(&watch_, &FileWatch::changed, this, &Document::changed_on_disk);
    connect(&undo_stack_, &QUndoStack::cleanChanged, this, [this] { emit modified_changed(is_modified()); });
    connect(&undo_stack_, &QUndoStack::indexChanged, this, [this](int step) {
        unread_.take_back(with_step(step + 1));
        unread_.begin_step(after_step(step));
    });
    unread_.begin_step(after_step(0));
}

Document::~Document() {
    undo_stack_.disconnect(this);
}

bool Document::apply(const QString& text, const ProjectEdit& edit, const QString& merge_key) {
    push_waiting();
    const ProjectSnapshot before = waiting_ ? waiting_->after : project_;
    auto after = std::make_shared<Project>(*before);
    edit(*after);
    if (*after == *before) return false;
    if (changing_)
        waiting_ = {text, merge_key, std::move(after)};
    else
        push(text, std::move(after), merge_key);
    return true;
}

void Document::begin_merging() {
    ++merge_series_;
    is_merging_ = true;
}

void Document::end_merging() {
    ++merge_series_;
    is_merging_ = false;
}

void Document::push(const QString& text, ProjectSnapshot after, const QString& merge_key) {
    const int window = is_merging_ ? std::numeric_limits<int>::max() : merge_window_;
    undo_stack_.push(new ProjectCommand(*this, text, std::move(after), {merge_key, merge_series_, window}));
    // Refused texts of a pasted block belong to the step, until the caller has returned.
    unread_.begin_step(with_step(undo_stack_.index()));
    QMetaObject::invokeMethod(
        this, [this] { unread_.begin_step(after_step(undo_stack_.index())); }, Qt::QueuedConnection);
    push_waiting();
}

void Document::undo() {
    if (!unread_.take_back(after_step(undo_stack_.index()))) undo_stack_.undo();
}

void Document::go_to_step(int index) {
    while (undo_stack_.index() > index && can_undo()) undo();
    while (undo_stack_.index() < index && undo_stack_.canRedo()) undo_stack_.redo();
}

bool Document::can_undo() const {
    return undo_stack_.canUndo() || unread_.has_since(after_step(undo_stack_.index()));
}

/// A step inside another would stand before it in the history.
void Document::push_waiting() {
    if (changing_ || !waiting_) return;
    const Waiting next = *std::exchange(waiting_, std::nullopt);
    push(next.text, next.after, next.merge_key);
}

void Document::set_project(ProjectSnapshot project, KeptProject::Pointer kept) {
    // Steps from before "save as" know the former folder.
    if (const auto folder = folder_of(file_); !file_.isEmpty() && project->directory != folder) {
        auto moved = std::make_shared<Project>(*project);
        moved->directory = folder;
        project = std::move(moved);
        kept = KeptProject::keep(*project, kept.get());
    }
    project_ = std::move(project);
    kept_ = std::move(kept);
    maker_.request(project_);
    const bool inside = std::exchange(changing_, true);
    emit project_changed();
    changing_ = inside;
    // Undo and redo do not come by `push`.
    if (waiting_) QMetaObject::invokeMethod(this, &Document::push_waiting, Qt::QueuedConnection);
}

/// Problems of a state that is no longer there would stand in the wrong places.
void Document::take_made() {
    if (maker_.made()->snapshot() != project_) return;
    of_made_ = maker_.problems();
    collect_problems();
}

void Document::collect_problems() {
    problems_ = unread_.problems(*project_);
    problems_.take(of_made_, {});
    emit problems_changed();
}

void Document::adopt(ProjectSnapshot project, const QString& file, const MadeProject::Pointer& made) {
    open_job_.cancel();
    undo_stack_.clear();
    waiting_.reset();
    unsaved_ = false;
    report_.clear();
    set_file(file);
    maker_.forget();
    of_made_ = {};
    project_ = std::move(project);
    kept_ = KeptProject::keep(*project_, nullptr);
    unread_.clear();
    emit project_replaced();
    if (made) maker_.take(made);
    set_project(project_, kept_);
    emit modified_changed(is_modified());
}

void Document::replace(Project project) {
    adopt(std::make_shared<const Project>(std::move(project)), {}, nullptr);
}

void Document::replace_by(const LoadedProject& loaded) {
    adopt(loaded.made->snapshot(), {}, loaded.made);
}

void Document::restore(const LoadedProject& loaded, const QString& original_file) {
    adopt(loaded.made->snapshot(), original_file, loaded.made);
    set_unsaved();
}

void Document::set_unsaved() {
    unsaved_ = true;
    emit modified_changed(true);
}

void Document::set_file(const QString& file) {
    watch_.watch(file);
    if (file == file_) return;
    file_ = file;
    emit file_changed();
}

QString Document::display_name() const {
    if (!file_.isEmpty()) return QFileInfo(file_).completeBaseName();
    return project_->title.empty() ? tr("Untitled") : to_qt(project_->title);
}

QString Document::heading() const {
    return report_.isEmpty() ? display_name() : tr("%1 (from %2)").arg(display_name(), report_);
}

Problems Document::open(const QString& file) {
    const LoadedProject loaded = load_file(file);
    adopt_opened(file, loaded);
    return refusal(loaded);
}

void Document::adopt_opened(const QString& file, const LoadedProject& loaded) {
    if (!loaded.is_whole) return;
    if (!is_report(file))
        return adopt(loaded.made->snapshot(), QFileInfo(file).absoluteFilePath(), loaded.made);
    replace_by(loaded);
    report_ = QFileInfo(file).fileName();
    set_unsaved();
    emit file_changed();
}

void Document::open_in_background(const QString& file) {
    const auto load = [this, file](const std::stop_token&) -> JobQueue::Delivery {
        // The content is taken before the file is read, so that a writer in between is noticed.
        const QByteArray content = FileWatch::content_of(file);
        auto loaded = std::make_shared<const LoadedProject>(load_file(file));
        return [this, file, loaded, content] {
            finish_open(file, *loaded);
            if (loaded->is_whole && watch_.file() == QFileInfo(file).absoluteFilePath())
                watch_.was_read_as(content);
        };
    };
    open_job_.start(load, [this, file](const Error& error) {
        Problems problems;
        problems.add({Severity::error, error.path, error.message, to_std(file), error.line});
        emit open_finished(file, problems);
    });
}

void Document::finish_open(const QString& file, const LoadedProject& loaded) {
    adopt_opened(file, loaded);
    emit open_finished(file, refusal(loaded));
}

Result<void> Document::save() {
    if (file_.isEmpty())
        return fail(ErrorCode::usage, to_std(tr("The project has no file yet: choose a name for it.")));
    if (!watch_.is_as_seen())
        return fail(ErrorCode::cancelled,
                    to_std(tr("Another program has changed the file since it was read.")));
    return save_as(file_);
}

Result<void> Document::save_as(const QString& file) {
    const QString absolute = QFileInfo(file).absoluteFilePath();
    if (absolute != file_)
        if (auto copied = copy_linked_files(*project_, folder_of(absolute)); !copied) return copied;
    if (auto saved = save_project(*project_, to_path(absolute)); !saved) return saved;
    report_.clear();
    set_file(absolute);
    if (project_->directory != folder_of(absolute)) set_project(project_, kept_);
    unsaved_ = false;
    end_merging();
    undo_stack_.setClean();
    emit modified_changed(false);
    return {};
}

}  // namespace covaria::ui
