#include "ui/main_window/file_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

#include "core/made/examples.h"
#include "ui/forms/finish_typing.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/languages.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

const QString recent_key = QStringLiteral("recentFiles");
constexpr int most_recent_files = 10;

QAction* make_action(QObject* parent, const char* picture, const QString& text,
                     QKeySequence::StandardKey key) {
    auto* action = new QAction(icon(QString::fromLatin1(picture)), text, parent);
    action->setShortcut(key);
    return action;
}

QStringList words_of(const std::vector<RecoveryEntry>& entries) {
    QStringList words;
    for (const RecoveryEntry& entry : entries)
        words << FileActions::tr("%1 (%2)").arg(
            entry.title, QLocale::system().toString(entry.saved_at, QLocale::ShortFormat));
    return words;
}

}  // namespace

QString errors_in_words(const Problems& problems) {
    QStringList lines;
    for (const Problem& problem : problems.items()) {
        if (problem.severity != Severity::error) continue;
        const QString place = problem.line > 0 ? FileActions::tr("line %1: ").arg(problem.line) : QString();
        lines << place + to_qt(problem.message);
        if (lines.size() == 12) break;
    }
    return lines.join(QLatin1Char('\n'));
}

FileActions::FileActions(Document& document, RecoveryStore store, QObject* parent)
    : QObject(parent), document_(document), store_(store), autosave_(document, std::move(store), this) {
    new_action = make_action(this, "new", tr("&New Project"), QKeySequence::New);
    open_action = make_action(this, "open", tr("&Open …"), QKeySequence::Open);
    save_action = make_action(this, "save", tr("&Save"), QKeySequence::Save);
    save_as_action = make_action(this, "save-as", tr("Save &As …"), QKeySequence::SaveAs);
    connect(new_action, &QAction::triggered, this, &FileActions::new_project);
    connect(open_action, &QAction::triggered, this, &FileActions::open);
    connect(save_action, &QAction::triggered, this, &FileActions::save);
    connect(save_as_action, &QAction::triggered, this, &FileActions::save_as);
    connect(&document_, &Document::open_finished, this, &FileActions::opened);
    connect(&document_, &Document::changed_on_disk, this, &FileActions::ask_about_disk_change,
            Qt::QueuedConnection);
    connect(&autosave_, &Autosave::failed, this, &FileActions::message);
}

QMenu* FileActions::make_recent_menu(QWidget* parent) {
    auto* menu = new QMenu(tr("Open &Recent"), parent);
    menu->setIcon(icon(QStringLiteral("recent")));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        for (const QString& file : recent_files())
            menu->addAction(QFileInfo(file).completeBaseName(), this, [this, file] { open_file(file); })
                ->setToolTip(file);
        if (menu->isEmpty()) menu->addAction(tr("No projects yet"))->setEnabled(false);
    });
    return menu;
}

QMenu* FileActions::make_examples_menu(QWidget* parent) {
    auto* menu = new QMenu(tr("New from &Example"), parent);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        for (const Example& example : shipped_examples())
            menu->addAction(core_text(example.title), this,
                            [this, file = from_path(example.file)] { open_example(file); });
    });
    return menu;
}

QStringList FileActions::recent_files() const {
    QStringList files;
    for (const QString& file : QSettings().value(recent_key).toStringList())
        if (QFileInfo::exists(file)) files << file;
    return files;
}

void FileActions::remember(const QString& file) {
    QStringList files = recent_files();
    files.removeAll(file);
    files.prepend(file);
    QSettings().setValue(recent_key, files.mid(0, most_recent_files));
    remember_folder_of(file);
    emit recent_changed();
}

void FileActions::new_project() {
    if (!may_leave()) return;
    Project project;
    project.title = tr("Untitled project").toStdString();
    // Documents of the project speak as the window does, until the project says otherwise.
    for (const CertificateLanguage& language : certificate_languages())
        if (spoken_language() == QLatin1String(language.code) && spoken_language() != QLatin1String("en"))
            project.certificate.language = language.code;
    document_.replace(std::move(project));
    emit project_opened();
}

void FileActions::open() {
    const QString file = dialogs.file_to_open(last_folder());
    if (!file.isEmpty()) open_file(file);
}

void FileActions::open_file(const QString& file) {
    if (!may_leave()) return;
    emit message(tr("Opening %1 …").arg(QFileInfo(file).fileName()));
    document_.open_in_background(QFileInfo(file).absoluteFilePath());
}

void FileActions::opened(const QString& file, const Problems& problems) {
    if (problems.has_errors()) {
        emit message(tr("%1 was not opened").arg(QFileInfo(file).fileName()));
        dialogs.show_message(tr("The project has errors and was not opened"),
                             QFileInfo(file).fileName() + QStringLiteral("\n\n") + errors_in_words(problems));
        return;
    }
    remember(file);
    emit message(tr("Opened %1").arg(QFileInfo(file).fileName()));
    emit project_opened();
}

void FileActions::open_example(const QString& file) {
    if (!may_leave()) return;
    const LoadedProject loaded = load_project(to_path(file));
    if (loaded.problems.has_errors()) {
        dialogs.show_message(tr("The example could not be opened"), errors_in_words(loaded.problems));
        return;
    }
    document_.replace_by(loaded);
    emit project_opened();
}

QString FileActions::suggested_file(const QString& ending) const {
    QString name = QFileInfo(document_.display_name()).completeBaseName();
    if (name.isEmpty()) name = document_.display_name();
    return QDir(last_folder()).filePath(name.replace(QLatin1Char('/'), QLatin1Char('-')) + ending);
}

bool FileActions::save() {
    finish_typing();
    if (document_.file().isEmpty()) return save_as();
    auto saved = document_.save();
    if (!saved && saved.error().code == ErrorCode::cancelled) {
        const QString question =
            tr("%1 was changed by another program since it was read here. Saving replaces "
               "what it holds now.");
        if (!dialogs.confirm(question.arg(QFileInfo(document_.file()).fileName()), tr("Replace")))
            return false;
        saved = document_.save_as(document_.file());
    }
    if (!saved) {
        dialogs.show_message(tr("The project was not saved"), to_qt(saved.error().message));
        return false;
    }
    tell_saved();
    return true;
}

bool FileActions::save_as() {
    finish_typing();
    QString file = dialogs.file_to_save(tr("Save Project"), suggested_file(QStringLiteral(".covaria")),
                                        tr("Covaria project (*.covaria)"));
    if (file.isEmpty()) return false;
    if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".covaria");
    if (to_qt(document_.project().title) == tr("Untitled project"))
        document_.apply(tr("Name project"), [&](Project& project) {
            project.title = to_std(QFileInfo(file).completeBaseName());
        });
    if (const auto saved = document_.save_as(file); !saved) {
        dialogs.show_message(tr("The project was not saved"), to_qt(saved.error().message));
        return false;
    }
    remember(file);
    tell_saved();
    return true;
}

/// The file has no place for what cannot be read.
void FileActions::tell_saved() {
    const QString name = QFileInfo(document_.file()).fileName();
    const int unread = document_.unread().count(document_.project());
    emit message(
        unread == 0 ? tr("Saved %1").arg(name)
                    : tr("Saved %1 without %n text(s) that cannot be read: see the problems", nullptr, unread)
                          .arg(name));
}

bool FileActions::may_leave() {
    finish_typing();
    // Texts that cannot be read are in no file.
    if (!document_.is_modified() && document_.unread().count(document_.project()) == 0) return true;
    switch (dialogs.save_changes(document_.display_name())) {
        case SaveAnswer::save:
            return save();
        case SaveAnswer::discard:
            return true;
        case SaveAnswer::cancel:
            return false;
    }
    return false;
}

bool FileActions::offer_recovery() {
    store_.remove_leftovers();
    const std::vector<RecoveryEntry> entries = store_.abandoned();
    if (entries.empty()) return false;
    const RecoverAnswer answer = dialogs.recover(words_of(entries));
    if (answer.what == RecoverAnswer::What::later) return false;
    const RecoveryEntry& entry = entries[static_cast<std::size_t>(answer.entry)];
    if (answer.what == RecoverAnswer::What::discard) {
        RecoveryStore::remove(entry.recovery_file);
        return false;
    }
    LoadedProject loaded = RecoveryStore::load(entry);
    if (!loaded.is_whole) {
        dialogs.show_message(tr("The work could not be recovered"), errors_in_words(loaded.problems));
        return false;
    }
    document_.restore(loaded, entry.original_file);
    autosave_.flush();  // first there is another copy, then the old one goes: whatever happens in between
    RecoveryStore::remove(entry.recovery_file);
    emit project_opened();
    return true;
}

void FileActions::ask_about_disk_change() {
    const QString file = document_.file();
    if (!QFileInfo::exists(file)) {
        emit message(
            tr("%1 was removed by another program; saving writes it again").arg(QFileInfo(file).fileName()));
        document_.set_unsaved();
        return;
    }
    if (dialogs.changed_on_disk(QFileInfo(file).fileName(), document_.is_modified()) == DiskAnswer::reload)
        document_.open_in_background(file);
    else
        document_.set_unsaved();
}

}  // namespace covaria::ui
