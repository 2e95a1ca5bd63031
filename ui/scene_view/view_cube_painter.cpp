#include "ui/scene_view/view_cube_painter.h"

#include <QPainter>
#include <algorithm>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr double room = 64.0;  // room for the cube whichever way it is turned
constexpr double cube_edge = room / 1.75;
constexpr double cube_margin = 16.0;
constexpr QSize least_view(360, 240);
constexpr double letters = 0.24;  // height, of the cube_edge

QPolygonF polygon_of(const CubeFace& face) {
    QPolygonF polygon;
    for (const Pixel& corner : face.corners) polygon << QPointF(corner.x, corner.y);
    return polygon;
}

void paint_letters(QPainter& painter, const CubeFace& face, const QPolygonF& polygon, const QColor& ink) {
    QTransform onto_face;
    const QPolygonF square{{0, 0}, {cube_edge, 0}, {cube_edge, cube_edge}, {0, cube_edge}};
    if (!QTransform::quadToQuad(square, polygon, onto_face)) return;
    painter.save();
    painter.setTransform(onto_face, true);
    QFont font = painter.font();
    font.setPixelSize(qRound(letters * cube_edge));
    font.setBold(true);
    const QString title = view_title(face.view);
    const double width = QFontMetricsF(font).horizontalAdvance(title);
    if (width > 0.92 * cube_edge)
        font.setPixelSize(std::max(5, qRound(letters * cube_edge * 0.92 * cube_edge / width)));
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(QRectF(0, 0, cube_edge, cube_edge), Qt::AlignCenter, title);
    painter.restore();
}

}  // namespace

QRectF cube_place(QSize view) {
    if (view.width() < least_view.width() || view.height() < least_view.height()) return {};
    return {view.width() - cube_margin - room, cube_margin, room, room};
}

std::vector<CubeFace> cube_in(const QRectF& place, const Camera& camera) {
    if (place.isEmpty()) return {};
    return view_cube(camera, {place.center().x(), place.center().y()}, cube_edge);
}

void paint_cube(QPainter& painter, const std::vector<CubeFace>& faces, std::optional<StandardView> pointed,
                const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ground = palette.color(QPalette::Button), line = palette.color(QPalette::Mid),
                 accent = palette.color(QPalette::Highlight);
    for (const CubeFace& face : faces) {
        const bool is_pointed = face.view == pointed;
        QColor fill = is_pointed ? accent : ground;
        // The top face is lighter, as if lit from above.
        if (!is_pointed) fill = face.view == StandardView::top ? fill.lighter(106) : fill.darker(104);
        fill.setAlphaF(0.92F);
        painter.setPen(QPen(is_pointed ? accent.darker(120) : line, 1.2));
        painter.setBrush(fill);
        const QPolygonF polygon = polygon_of(face);
        painter.drawPolygon(polygon);
        paint_letters(painter, face, polygon,
                      palette.color(is_pointed ? QPalette::HighlightedText : QPalette::ButtonText));
    }
    painter.restore();
}

QString view_title(StandardView view) {
    switch (view) {
        case StandardView::iso:
            return tr("Isometric");
        case StandardView::top:
            return tr("Top");
        case StandardView::front:
            return tr("Front");
        case StandardView::right:
            return tr("Right");
        case StandardView::bottom:
            return tr("Bottom");
        case StandardView::back:
            return tr("Back");
        case StandardView::left:
            return tr("Left");
    }
    return {};
}

}  // namespace covaria::ui
