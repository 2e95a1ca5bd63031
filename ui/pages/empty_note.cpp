#include "ui/pages/empty_note.h"

#include <QEvent>

#include "ui/theme/theme.h"

namespace covaria::ui {

EmptyNote::EmptyNote(QWidget* parent) : QLabel(parent) {
    setAlignment(Qt::AlignCenter);
    setWordWrap(true);
    setMargin(12);
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    take_theme();
}

void EmptyNote::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) take_theme();
}

/// Takes the quiet colour that texts of empty charts have, too.
void EmptyNote::take_theme() {
    const QColor quiet = Theme::of(palette()).tokens().ink2;
    if (palette().color(QPalette::WindowText) == quiet) return;
    QPalette own = palette();
    own.setColor(QPalette::WindowText, quiet);
    setPalette(own);
}

}  // namespace covaria::ui
