#include "ui/main_window/dialogs.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

const QString folder_key = QStringLiteral("lastFolder");

SaveAnswer ask_save(QWidget* parent, const QString& name) {
    QMessageBox box(QMessageBox::Question, tr("Unsaved Changes"), tr("Save the changes to “%1”?").arg(name),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(tr("Without saving they are lost."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
        case QMessageBox::Save:
            return SaveAnswer::save;
        case QMessageBox::Discard:
            return SaveAnswer::discard;
        default:
            return SaveAnswer::cancel;
    }
}

DiskAnswer ask_reload(QWidget* parent, const QString& name, bool modified) {
    QMessageBox box(QMessageBox::Question, tr("File Changed"), tr("Another program changed “%1”.").arg(name),
                    QMessageBox::NoButton, parent);
    box.setInformativeText(modified ? tr("Reading it again loses your unsaved changes.")
                                    : tr("It can be read again."));
    auto* reload = box.addButton(tr("Read Again"), QMessageBox::AcceptRole);
    box.addButton(tr("Keep Mine"), QMessageBox::RejectRole);
    box.exec();
    return box.clickedButton() == reload ? DiskAnswer::reload : DiskAnswer::keep;
}

RecoverAnswer ask_recover(QWidget* parent, const QStringList& entries) {
    using What = RecoverAnswer::What;
    QMessageBox box(QMessageBox::Question, tr("Recover Unsaved Work"),
                    tr("Covaria did not end properly. Unsaved work was kept:"), QMessageBox::NoButton,
                    parent);
    auto* list = new QComboBox(&box);
    list->addItems(entries);
    list->setAccessibleName(tr("Kept projects"));
    if (auto* grid = qobject_cast<QGridLayout*>(box.layout())) grid->addWidget(list, 1, 2);
    auto* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
    auto* later = box.addButton(tr("Later"), QMessageBox::RejectRole);
    auto* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    box.setDefaultButton(recover);
    box.setEscapeButton(later);
    box.exec();
    const What what = box.clickedButton() == recover   ? What::recover
                      : box.clickedButton() == discard ? What::discard
                                                       : What::later;
    return {what, list->currentIndex()};
}

bool ask_confirm(QWidget* parent, const QString& question, const QString& action) {
    QMessageBox box(QMessageBox::Question, action, question, QMessageBox::Cancel, parent);
    auto* go = box.addButton(action, QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == go;
}

}  // namespace

QString last_folder() {
    const QString folder = QSettings().value(folder_key).toString();
    return !folder.isEmpty() && QDir(folder).exists()
               ? folder
               : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void remember_folder_of(const QString& file) {
    QSettings().setValue(folder_key, QFileInfo(file).absolutePath());
}

Dialogs standard_dialogs(QWidget* parent) {
    Dialogs dialogs;
    dialogs.file_to_open = [parent](const QString& folder) {
        return QFileDialog::getOpenFileName(parent, tr("Open Project"), folder,
                                            tr("Covaria project or report (*.covaria *.pdf)"));
    };
    dialogs.file_to_import = [parent](const QString& title, const QString& folder, const QString& filter) {
        return QFileDialog::getOpenFileName(parent, title, folder, filter);
    };
    dialogs.file_to_save = [parent](const QString& title, const QString& suggested, const QString& filter) {
        return QFileDialog::getSaveFileName(parent, title, suggested, filter);
    };
    dialogs.folder_to_search = [parent](const QString& title) {
        return QFileDialog::getExistingDirectory(parent, title, last_folder());
    };
    dialogs.save_changes = [parent](const QString& name) { return ask_save(parent, name); };
    dialogs.changed_on_disk = [parent](const QString& name, bool modified) {
        return ask_reload(parent, name, modified);
    };
    dialogs.recover = [parent](const QStringList& entries) { return ask_recover(parent, entries); };
    dialogs.confirm = [parent](const QString& question, const QString& action) {
        return ask_confirm(parent, question, action);
    };
    dialogs.ask_text = [parent](const QString& title, const QString& label, const QString& text) {
        bool accepted = false;
        const QString answer =
            QInputDialog::getText(parent, title, label, QLineEdit::Normal, text, &accepted);
        return accepted ? answer : QString();
    };
    dialogs.show_message = [parent](const QString& title, const QString& message) {
        QMessageBox::warning(parent, title, message);
    };
    return dialogs;
}

}  // namespace covaria::ui
