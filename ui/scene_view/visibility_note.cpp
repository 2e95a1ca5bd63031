#include "ui/scene_view/visibility_note.h"

#include <QPainter>
#include <QWidget>
#include <algorithm>

#include "ui/theme/strings.h"

namespace covaria::ui {

QString visibility_words(const Scene& whole, const Visibility& visibility) {
    if (const SceneItem* only = find_item(whole, visibility.only))
        return QObject::tr("Only %1 is shown (Shift+H: all)").arg(to_qt(name_of(*only)));
    const auto hidden = std::ranges::count_if(
        visibility.hidden, [&](const std::string& id) { return find_item(whole, id) != nullptr; });
    return hidden == 0 ? QString() : QObject::tr("%n hidden (Shift+H: show all)", nullptr, int(hidden));
}

namespace {
constexpr int lines_of_title = 3;  // title of the scene and of its shown part, with their margin
constexpr int room_of_cube = 96;
}  // namespace

void paint_note(QPainter& painter, const QWidget& view, const QString& words) {
    constexpr int left_and_right = 8, top_and_bottom = 3;
    QRect box = view.fontMetrics().boundingRect(words).adjusted(-left_and_right, -top_and_bottom,
                                                                left_and_right, top_and_bottom);
    box.moveTopRight({view.width() - room_of_cube, lines_of_title * view.fontMetrics().height()});
    painter.setPen(view.palette().color(QPalette::Mid));
    painter.setBrush(view.palette().color(QPalette::Window));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(view.palette().color(QPalette::WindowText));
    painter.drawText(box, Qt::AlignCenter, words);
}

}  // namespace covaria::ui
