// The effects of mouse, keys and menus on a chart in the window.
#include <QContextMenuEvent>
#include <QGraphicsScene>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QRubberBand>
#include <QWheelEvent>
#include <cmath>

#include "ui/charts/chart_view.h"
#include "ui/theme/label_text.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

void ChartView::resizeEvent(QResizeEvent* event) {
    QGraphicsView::resizeEvent(event);
    scene()->setSceneRect(QRectF(QPointF(), viewport()->size()));
    chart_->resize(viewport()->size());
    show_read_out({});
}

void ChartView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !can_zoom()) return;
    if (chart_->chart_layout().geometry.area.contains(event->position()))
        pressed_ = event->position().toPoint();
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
    if (pressed_) {
        const QRect area = chart_->chart_layout().geometry.area.toAlignedRect();
        band_->setGeometry(QRect(*pressed_, event->position().toPoint()).normalized().intersected(area));
        band_->show();
        return;
    }
    show_read_out(read_out(plot(), chart_->chart_layout().geometry, event->position()));
    viewport()->setCursor(is_over_link() ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

bool ChartView::is_over_link() const {
    return read_out_ && read_out_->bar && int(*read_out_->bar) < clickable_bars_;
}

void ChartView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !pressed_ && is_over_link())
        emit bar_clicked(int(*read_out_->bar));
    if (!pressed_ || event->button() != Qt::LeftButton) return;
    const QRectF rect(*pressed_, event->position().toPoint());
    pressed_.reset();
    band_->hide();
    zoom_to(rect.normalized());
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) reset_zoom();
}

void ChartView::wheelEvent(QWheelEvent* event) {
    zoom_by(std::pow(0.8, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

void ChartView::leaveEvent(QEvent* event) {
    show_read_out({});
    QGraphicsView::leaveEvent(event);
}

void ChartView::keyPressEvent(QKeyEvent* event) {
    const QPointF centre = chart_->chart_layout().geometry.area.center();
    if (event->matches(QKeySequence::Copy))
        copy_image();
    else if (event->key() == Qt::Key_Plus)
        zoom_by(0.8, centre);
    else if (event->key() == Qt::Key_Minus)
        zoom_by(1.25, centre);
    else if (event->key() == Qt::Key_0 || (event->key() == Qt::Key_Escape && is_zoomed()))
        reset_zoom();
    else
        QGraphicsView::keyPressEvent(event);
}

void ChartView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    const bool filled = !plot().series.empty();
    menu.addAction(tr("Show All"), this, &ChartView::reset_zoom)->setEnabled(is_zoomed());
    menu.addSeparator();
    for (QAction* action : {menu.addAction(tr("Copy Picture"), this, &ChartView::copy_image),
                            menu.addAction(tr("Copy Data"), this, &ChartView::copy_data)})
        action->setEnabled(filled);
    menu.addSeparator();
    for (const QString& ending : {QStringLiteral("png"), QStringLiteral("svg"), QStringLiteral("csv")})
        menu.addAction(tr("Save as %1 …").arg(ending.toUpper()), this, [this, ending] { save_as(ending); })
            ->setEnabled(filled);
    menu.exec(event->globalPos());
}

void ChartView::show_read_out(const std::optional<ReadOut>& value) {
    const QString before = read_out_ ? to_qt(to_unicode(read_out_->text)) : QString();
    read_out_ = value;
    const QString now = value ? to_qt(to_unicode(value->text)) : QString();
    if (before == now) return;
    emit read_out_changed(now);
    viewport()->update();
}

/// The read-out stands at the right end of the title's line, on the ground of the chart.
void ChartView::drawForeground(QPainter* painter, const QRectF&) {
    if (!read_out_) return;
    const ChartFonts& fonts = chart_->chart_layout().fonts;
    const LabelText label(read_out_->text, fonts.figures);
    const QRectF box(chart_->size().width() - label.width() - 10.0, 6.0, label.width(), label.height());
    painter->fillRect(box.adjusted(-6.0, -1.0, 6.0, 1.0), theme_.tokens().stage);
    painter->setPen(theme_.tokens().ink);
    label.draw(*painter, box.topLeft());
    if (!read_out_->point) return;
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme_.tokens().ink, 1.2));
    painter->drawEllipse(*read_out_->point, 4.5, 4.5);
}

}  // namespace covaria::ui
