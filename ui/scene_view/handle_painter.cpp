#include "ui/scene_view/handle_painter.h"

#include <QLineF>
#include <QObject>
#include <QPainter>
#include <QPolygonF>

namespace covaria::ui {

namespace {

constexpr double width = 2.2, width_grasped = 4.0;
constexpr double head_length = 9.0, head_angle = 24.0;
constexpr double radius_of_tip = 5.0;

}  // namespace

QString handle_words(const Handle& handle, const Camera& camera) {
    static constexpr char axes[] = "xyz";
    if (handle.turns())
        return QObject::tr("Turns about its %1 axis").arg(QLatin1Char(axes[turning_axis(handle, camera)]));
    return handle.axis < 0 ? QString() : QObject::tr("Moves along %1").arg(QLatin1Char(axes[handle.axis]));
}

void paint_handles(QPainter& painter, const HandleMarks& marks, int grasped, ScenePalette colours,
                   double ratio) {
    static constexpr Role roles[] = {Role::axis_x, Role::axis_y, Role::axis_z};
    const auto point = [ratio](Pixel pixel) { return QPointF(pixel.x, pixel.y) / ratio; };
    const auto colour_of_axis = [&](int axis) {
        const detail::Colour colour = detail::colour_of(roles[axis], colours);
        return QColor(colour.red, colour.green, colour.blue);
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const HandleMarks::Arrow& arrow : marks.arrows) {
        const QColor colour = colour_of_axis(arrow.axis);
        const QPointF to = point(arrow.to);
        painter.setPen(
            QPen(colour, grasped == arrow.axis ? width_grasped : width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(point(arrow.from), to);
        QLineF side = QLineF(to, point(arrow.from));
        side.setLength(head_length);
        const double back = side.angle();
        QPolygonF head{to};
        for (const double turn : {-head_angle, head_angle}) {
            side.setAngle(back + turn);
            head << side.p2();
        }
        painter.setBrush(colour);
        painter.drawPolygon(head);
    }
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < marks.tips.size(); ++i) {
        painter.setPen(QPen(colour_of_axis(int(i % 3)), width));
        painter.drawEllipse(point(marks.tips[i]), radius_of_tip, radius_of_tip);
    }
    painter.restore();
}

}  // namespace covaria::ui
