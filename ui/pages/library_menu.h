// The menu with the assets of the library, by collection.
#pragma once

#include <QMenu>

#include "ui/document/document.h"
#include "ui/document/selection.h"

namespace covaria {
struct LibraryItem;
}

namespace covaria::ui {

/// In the language of the window; as its owner called it if it is the user's own.
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
