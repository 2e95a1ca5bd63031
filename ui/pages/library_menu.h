// The menu with the assets of the library, by collection.
#pragma once

#include <QMenu>

#include "ui/document/document.h"
#include "ui/document/selection.h"

namespace covaria {
struct LibraryItem;
}

namespace covaria::ui {

/// Title in the language of the window; the user's own collections keep the name that the user gave.
QString collection_title(const LibraryItem& item);

/// Reads the library whenever it opens, so that new files appear. A chosen asset is copied into the project
/// and selected.
class LibraryMenu : public QMenu {
    Q_OBJECT
public:
    LibraryMenu(Document& document, Selection& selection, QWidget* parent);

private:
    void fill();

    Document& document_;
    Selection& selection_;
};

}  // namespace covaria::ui
