#include "ui/pages/notes_page.h"

#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>

#include "ui/document/project_edits.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

NotesPage::NotesPage(Document& document, SetupAddress entry, QWidget* parent)
    : QWidget(parent), document_(document), entry_(std::move(entry)) {
    name_ = new QLineEdit;
    notes_ = new QPlainTextEdit;
    const QString name = entry_.owner == SetupOwner::project ? tr("Title") : tr("Name");
    name_->setObjectName(QStringLiteral("entry_name"));
    notes_->setObjectName(QStringLiteral("entry_notes"));
    name_->setAccessibleName(name);
    notes_->setAccessibleName(tr("Notes"));
    notes_->setToolTip(tr("Appear in the report"));
    notes_->setTabChangesFocus(true);
    auto* form = new QFormLayout(this);
    form->addRow(name, name_);
    form->addRow(tr("Notes"), notes_);
    refresh();
    connect(name_, &QLineEdit::editingFinished, this, &NotesPage::take_name);
    connect(notes_, &QPlainTextEdit::textChanged, this,
            [this] { set_notes(document_, entry_, notes_->toPlainText()); });
    connect(&document_, &Document::project_changed, this, &NotesPage::refresh);
}

/// An entry without a name could not be told from others: then the name stays.
void NotesPage::take_name() {
    const QString name = name_->text().trimmed();
    name_->setModified(false);
    if (!name.isEmpty()) rename(document_, entry_, name);
    refresh();
}

void NotesPage::refresh() {
    const Project& project = document_.project();
    const AssetEntry* asset = entry_.owner == SetupOwner::asset ? project.find_asset(entry_.id) : nullptr;
    const AnalysisEntry* analysis =
        entry_.owner == SetupOwner::analysis ? project.find_analysis(entry_.id) : nullptr;
    if (!exists(project, entry_)) return;
    const QString name = to_qt(asset ? asset->name : analysis ? analysis->name : project.title);
    const QString notes = to_qt(asset ? asset->notes : analysis ? analysis->notes : project.notes);
    if (name != name_->text() && !(name_->hasFocus() && name_->isModified())) name_->setText(name);
    const QSignalBlocker blocker(notes_);
    if (notes != notes_->toPlainText()) notes_->setPlainText(notes);
}

}  // namespace covaria::ui
