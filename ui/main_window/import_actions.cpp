#include "ui/main_window/import_actions.h"

#include <QFileInfo>

#include "core/base/file_io.h"
#include "core/kinds/robot/urdf.h"
#include "core/readers/readers.h"
#include "ui/document/project_edits.h"
#include "ui/forms/import_dialog.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

ImportActions::ImportActions(Document& document, Dialogs& dialogs, QObject* parent)
    : QObject(parent), document_(document), dialogs_(dialogs) {
    import_action = new QAction(icon(QStringLiteral("open")), tr("&Import File …"), this);
    import_action->setToolTip(tr("Add points, budgets, certificates, readings or poses of other programs"));
    connect(import_action, &QAction::triggered, this, &ImportActions::ask_for_file);
    urdf_action = new QAction(icon(QStringLiteral("robot")), tr("Import Robo&t (URDF) …"), this);
    urdf_action->setToolTip(tr("Add a serial robot from a robot description in URDF"));
    connect(urdf_action, &QAction::triggered, this, &ImportActions::ask_for_urdf);
}

void ImportActions::ask_for_file() {
    QStringList patterns;
    for (const Reader& reader : reader_registry()) patterns << to_qt(reader.pattern).split(QLatin1Char(' '));
    patterns.removeDuplicates();
    const QString file = dialogs_.file_to_import(
        tr("Import File"), last_folder(),
        tr("Files that are read (%1);;All files (*)").arg(patterns.join(QLatin1Char(' '))));
    if (file.isEmpty()) return;
    remember_folder_of(file);
    import_file(file);
}

void ImportActions::import_file(const QString& file) {
    if (file.endsWith(QStringLiteral(".urdf"), Qt::CaseInsensitive)) return import_urdf_file(file);
    auto* dialog = new ImportDialog(file, qobject_cast<QWidget*>(parent()));
    dialog->setObjectName(QStringLiteral("import"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, file] { take_over(QFileInfo(file).fileName(), dialog->proposals()); });
    dialog->open();
}

void ImportActions::take_over(const QString& name, const Proposals& proposals) {
    emit accepted();
    const std::size_t assets = document_.project().assets.size(),
                      analyses = document_.project().analyses.size();
    document_.apply(tr("Import %1").arg(name), [&](Project& project) { add_to_project(project, proposals); });
    emit message(tr("Imported %1").arg(name));
    const Project& project = document_.project();
    if (project.analyses.size() > analyses)
        emit imported({SetupOwner::analysis, project.analyses[analyses].id});
    else if (project.assets.size() > assets)
        emit imported({SetupOwner::asset, project.assets[assets].id});
}

void ImportActions::ask_for_urdf() {
    const QString file = dialogs_.file_to_import(tr("Import Robot"), last_folder(),
                                                 tr("Robot description (*.urdf);;All files (*)"));
    if (file.isEmpty()) return;
    remember_folder_of(file);
    import_urdf_file(file);
}

void ImportActions::import_urdf_file(const QString& file) {
    const QString name = QFileInfo(file).fileName();
    const auto text = read_file(to_path(file));
    if (!text) return dialogs_.show_message(tr("The robot was not imported"), to_qt(text.error().message));
    auto robot = import_urdf(*text);
    if (!robot) {
        dialogs_.show_message(tr("The robot was not imported"),
                              name + QStringLiteral("\n\n") + to_qt(robot.error().message));
        return;
    }
    emit accepted();
    AssetEntry entry{unique_id(document_.project(), robot->name), robot->kind,
                     unique_name(document_.project(), robot->name), robot->notes, robot->setup};
    document_.apply(tr("Import %1").arg(to_qt(entry.name)),
                    [&](Project& project) { project.assets.push_back(entry); });
    emit message(tr("Imported %1").arg(name));
    emit imported({SetupOwner::asset, entry.id});
}

}  // namespace covaria::ui
