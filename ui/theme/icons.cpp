// An icon engine that renders a drawing with its strokes in the palette's colour.
#include "ui/theme/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "core/base/resource_path.h"

namespace covaria::ui {
namespace {

QColor colour_of(QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
    return palette.color(QPalette::ButtonText);
}

class DrawnIcon : public QIconEngine {
public:
    DrawnIcon(QString name, QByteArray drawing) : name_(std::move(name)), drawing_(std::move(drawing)) {}

    QIconEngine* clone() const override { return new DrawnIcon(*this); }
    bool isNull() override { return false; }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QByteArray coloured = drawing_;
        coloured.replace("currentColor", colour_of(mode).name().toLatin1());
        QSvgRenderer(coloured).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QStringLiteral("covaria-icon:%1:%2x%3:%4")
                                .arg(name_, QString::number(size.width()), QString::number(size.height()),
                                     colour_of(mode).name());
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap)) return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

private:
    QString name_;
    QByteArray drawing_;
};

/// Read once; empty when there is no such drawing.
QByteArray drawing_of(const QString& name) {
    static QHash<QString, QByteArray> drawings;
    if (const auto found = drawings.constFind(name); found != drawings.constEnd()) return *found;
    const auto path = data_directory() / "resources" / "icons" / (name.toStdString() + ".svg");
    QFile file(QString::fromStdString(path.string()));
    const QByteArray drawing = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    drawings.insert(name, drawing);
    return drawing;
}

}  // namespace

QIcon icon(const QString& name) {
    const QByteArray drawing = drawing_of(name);
    return drawing.isEmpty() ? QIcon() : QIcon(new DrawnIcon(name, drawing));
}

}  // namespace covaria::ui
