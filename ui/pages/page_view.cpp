#include "ui/pages/page_view.h"

#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace covaria::ui {
namespace {

constexpr double screen_dots_per_inch = 96.0;  // units of widgets per inch, at a factor of 1
constexpr int page_gap = 16;
constexpr int page_margin = 12;
constexpr double least_scale = 0.1;
constexpr int wheel_notch = 120;

}  // namespace

PageView::PageView(QWidget* parent) : QAbstractScrollArea(parent) {
    setObjectName(QStringLiteral("report_pages"));
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setBackgroundRole(QPalette::AlternateBase);
    viewport()->setAutoFillBackground(true);
}

const std::vector<double>& PageView::offered_factors() {
    static const std::vector<double> factors{0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0};
    return factors;
}

void PageView::set_pages(std::vector<PrintedPage> pages) {
    const int before = current_;
    pages_ = std::move(pages);
    shown_.clear();
    lay_out();
    current_ = -1;
    go_to_page(std::clamp(before, 0, std::max(0, page_count() - 1)));
    take_current_page();
    viewport()->update();
}

/// The vertical scroll bar always has its room: without it a fitted width would come and go with the bar.
double PageView::scale() const {
    if (zoom_.fit == PageZoom::Fit::none || pages_.empty()) return zoom_.factor;
    const QSizeF paper = pages_.front().inches * screen_dots_per_inch;
    const int bar = verticalScrollBar()->isVisible() ? 0 : verticalScrollBar()->sizeHint().width();
    const double across = (viewport()->width() - bar - 2 * page_margin) / paper.width();
    const double down = (viewport()->height() - 2 * page_margin) / paper.height();
    return std::max(least_scale, zoom_.fit == PageZoom::Fit::width ? across : std::min(across, down));
}

QSizeF PageView::page_size(int page) const {
    return pages_[std::size_t(page)].inches * screen_dots_per_inch * scale();
}

/// Distance of a page from the top of the first page's margin.
int PageView::top_of(int page) const {
    double top = page_margin;
    for (int above = 0; above < page; ++above) top += page_size(above).height() + page_gap;
    return int(std::lround(top));
}

QRect PageView::page_rect(int page) const {
    const QSize size = page_size(page).toSize();
    const int room = viewport()->width();
    const int left = size.width() + 2 * page_margin > room ? page_margin - horizontalScrollBar()->value()
                                                           : (room - size.width()) / 2;
    return {QPoint(left, top_of(page) - verticalScrollBar()->value()), size};
}

void PageView::lay_out() {
    double widest = 0.0;
    for (int page = 0; page < page_count(); ++page) widest = std::max(widest, page_size(page).width());
    const int height = pages_.empty() ? 0 : top_of(page_count()) - page_gap + page_margin;
    const QSize room = viewport()->size();
    verticalScrollBar()->setPageStep(room.height());
    verticalScrollBar()->setSingleStep(3 * fontMetrics().lineSpacing());
    verticalScrollBar()->setRange(0, std::max(0, height - room.height()));
    horizontalScrollBar()->setPageStep(room.width());
    horizontalScrollBar()->setSingleStep(3 * fontMetrics().lineSpacing());
    const int width = zoom_.fit == PageZoom::Fit::none ? int(std::lround(widest)) + 2 * page_margin : 0;
    horizontalScrollBar()->setRange(0, std::max(0, width - room.width()));
}

void PageView::go_to_page(int page) {
    if (page < 0 || page >= page_count()) return;
    verticalScrollBar()->setValue(top_of(page) - page_margin);
}

void PageView::set_zoom(PageZoom zoom) {
    zoom.factor = std::clamp(zoom.factor, offered_factors().front(), offered_factors().back());
    if (zoom == zoom_) return;
    const QPoint middle = viewport()->rect().center();
    const int page = current_;  // a bar that goes makes a resize, which finds another one
    const QRect before = page < 0 ? QRect() : page_rect(page);
    zoom_ = zoom;
    lay_out();
    if (before.isValid()) {
        const double down = double(middle.y() - before.top()) / before.height();
        const double across = double(middle.x() - before.left()) / before.width();
        const QSizeF size = page_size(page);
        verticalScrollBar()->setValue(top_of(page) + int(down * size.height()) - middle.y());
        horizontalScrollBar()->setValue(page_margin + int(across * size.width()) - middle.x());
    }
    take_current_page();
    viewport()->update();
    emit zoom_changed();
}

void PageView::step_zoom(int direction) {
    const double now = scale();
    const std::vector<double>& factors = offered_factors();
    constexpr double nearly = 0.005;
    double wanted = direction > 0 ? factors.back() : factors.front();
    for (const double factor : factors) {
        if (direction > 0 && factor > now + nearly) wanted = std::min(wanted, factor);
        if (direction < 0 && factor < now - nearly) wanted = std::max(wanted, factor);
    }
    set_zoom({PageZoom::Fit::none, wanted});
}

/// Makes the page with the most of it in view the current one.
void PageView::take_current_page() {
    int best = pages_.empty() ? -1 : 0, most = -1;
    for (int page = 0; page < page_count(); ++page) {
        const QRect seen = page_rect(page) & viewport()->rect();
        const int height = seen.isValid() ? seen.height() : 0;
        if (height <= most) continue;
        most = height;
        best = page;
    }
    if (best >= 0) above_ = -page_rect(best).top() / page_size(best).height();
    if (best == current_) return;
    current_ = best;
    emit current_page_changed(current_);
}

/// Picture of a page as large as it is seen; those out of view are forgotten.
const QImage& PageView::sharp(int page) {
    const double dots = screen_dots_per_inch * scale() * devicePixelRatioF();
    if (dots != shown_scale_) shown_.clear();
    shown_scale_ = dots;
    std::erase_if(shown_, [this](const auto& one) {
        return one.first >= page_count() || !page_rect(one.first).intersects(viewport()->rect());
    });
    const auto found = shown_.find(page);
    if (found != shown_.end()) return found->second;
    return shown_.emplace(page, page_image(pages_[std::size_t(page)], dots)).first->second;
}

void PageView::paintEvent(QPaintEvent* event) {
    QPainter painter(viewport());
    for (int page = 0; page < page_count(); ++page) {
        const QRect rect = page_rect(page);
        if (!rect.intersects(event->rect())) continue;
        painter.drawImage(rect, sharp(page));
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawRect(rect.adjusted(0, 0, -1, -1));
    }
}

void PageView::resizeEvent(QResizeEvent*) {
    const int page = current_;
    const double above = above_;
    lay_out();
    if (page >= 0 && zoom_.fit != PageZoom::Fit::none)  // the same lines stay in view
        verticalScrollBar()->setValue(top_of(page) + int(std::lround(above * page_size(page).height())));
    take_current_page();
    if (zoom_.fit != PageZoom::Fit::none) emit zoom_changed();
}

void PageView::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QAbstractScrollArea::wheelEvent(event);
    wheel_ += event->angleDelta().y();
    for (; wheel_ >= wheel_notch; wheel_ -= wheel_notch) step_zoom(1);
    for (; wheel_ <= -wheel_notch; wheel_ += wheel_notch) step_zoom(-1);
    event->accept();
}

/// Adds to the keys of a scroll area Home and End, and the space bar as in readers.
void PageView::keyPressEvent(QKeyEvent* event) {
    QScrollBar* bar = verticalScrollBar();
    switch (event->key()) {
        case Qt::Key_Home:
            return bar->setValue(bar->minimum());
        case Qt::Key_End:
            return bar->setValue(bar->maximum());
        case Qt::Key_Space:
            return bar->triggerAction(event->modifiers() & Qt::ShiftModifier
                                          ? QAbstractSlider::SliderPageStepSub
                                          : QAbstractSlider::SliderPageStepAdd);
        default:
            QAbstractScrollArea::keyPressEvent(event);
    }
}

void PageView::scrollContentsBy(int, int) {
    take_current_page();
    viewport()->update();
}

}  // namespace covaria::ui
