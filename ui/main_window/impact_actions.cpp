#include "ui/main_window/impact_actions.h"

#include <QFileInfo>

#include "ui/forms/impact_form.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/impact_dialog.h"
#include "ui/theme/icons.h"

namespace covaria::ui {

ImpactActions::ImpactActions(QWidget& window, Document& document, Selection& selection, FileActions& files)
    : QObject(&window),
      action(new QAction(icon(QStringLiteral("impact")), tr("&What Hangs on a Certificate …"), this)),
      window_(window),
      document_(document),
      selection_(selection),
      files_(files) {
    connect(action, &QAction::triggered, this, [this] { ask_about({}); });
}

void ImpactActions::ask_about(const QString& certificate) {
    ImpactForm& form = dialog().form();
    form.offer(document_.project(), selection_.entry());
    if (!certificate.isEmpty()) form.ask_about(certificate);
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
}

ImpactDialog& ImpactActions::dialog() {
    if (!dialog_) {
        dialog_ = new ImpactDialog(files_.dialogs, &window_);
        if (!document_.file().isEmpty()) dialog_->form().add_place(QFileInfo(document_.file()).path());
        connect(dialog_, &ImpactDialog::file_wanted, &files_, &FileActions::open_file);
    }
    return *dialog_;
}

}  // namespace covaria::ui
