#include "ui/pages/library_menu.h"

#include <map>

#include "core/made/library.h"
#include "ui/document/project_edits.h"
#include "ui/theme/core_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

QString collection_title(const LibraryItem& item) {
    return item.own ? to_qt(item.collection) : core_text(item.collection);
}

LibraryMenu::LibraryMenu(Document& document, Selection& selection, QWidget* parent)
    : QMenu(tr("F&rom the Library"), parent), document_(document), selection_(selection) {
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &LibraryMenu::fill);
}

void LibraryMenu::fill() {
    clear();
    const Library library = load_library();
    std::map<std::string, QMenu*> collections;
    for (const LibraryItem& item : library.items) {
        QMenu*& menu = collections[item.collection];
        if (!menu) {
            menu = addMenu(collection_title(item));
            menu->setToolTipsVisible(true);
        }
        QAction* action = menu->addAction(to_qt(item.asset.name), this, [this, asset = item.asset] {
            selection_.select_entry({SetupOwner::asset, add_copy(document_, asset)});
        });
        action->setToolTip(QStringLiteral("<p>%1</p>").arg(to_qt(item.asset.notes).toHtmlEscaped()));
    }
    for (const Problem& problem : library.problems.items()) {
        QAction* action = addAction(tr("Not readable: %1").arg(to_qt(problem.message)));
        action->setEnabled(false);
    }
}

}  // namespace covaria::ui
