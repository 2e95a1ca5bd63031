// The curve covers all but a thousandth of the probability at either side.
#include "ui/forms/density_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

namespace covaria::ui {

namespace {

constexpr double tail = 1e-3;
constexpr int points = 160;

struct Curve {
    double low = 0.0, high = 0.0;
    std::vector<QPointF> points;  ///< x in SI, y = density, from low to high
    bool bars = false;
};

Discrete without_far_tails(const Discrete& all) {
    const double most = *std::max_element(all.probabilities.begin(), all.probabilities.end());
    Discrete seen;
    for (std::size_t i = 0; i < all.values.size(); ++i) {
        if (all.probabilities[i] < tail * most) continue;
        seen.values.push_back(all.values[i]);
        seen.probabilities.push_back(all.probabilities[i]);
    }
    return seen;
}

Curve bars_of(const Discrete& discrete) {
    Curve curve;
    const auto [low, high] = std::minmax_element(discrete.values.begin(), discrete.values.end());
    const double margin = std::max(0.1 * (*high - *low), 1e-12);
    curve = {*low - margin, *high + margin, {}, true};
    for (std::size_t i = 0; i < discrete.values.size(); ++i)
        curve.points.emplace_back(discrete.values[i], discrete.probabilities[i]);
    return curve;
}

Curve curve_of(const Distribution& distribution) {
    if (distribution.has_jumps()) return bars_of(without_far_tails(values_with_probabilities(distribution)));
    Curve curve;
    const double low = distribution.quantile(tail);
    const double high = distribution.quantile(1.0 - tail);
    if (!(high > low)) {  // a constant
        const double margin = std::max(std::abs(low), 1.0);
        return {low - margin, low + margin, {QPointF(low, 1.0)}, true};
    }
    const double margin = 0.12 * (high - low);
    curve.low = low - margin;
    curve.high = high + margin;
    for (int i = 0; i <= points; ++i) {
        const double x = curve.low + (curve.high - curve.low) * i / points;
        const double density = distribution.density(x);
        curve.points.emplace_back(x, std::isfinite(density) ? density : 0.0);
    }
    return curve;
}

/// Highest density drawn: a pole (arcsine at its ends) would flatten everything else.
double ceiling_of(const Curve& curve) {
    std::vector<double> heights;
    for (const QPointF& point : curve.points) heights.push_back(point.y());
    std::sort(heights.begin(), heights.end());
    const double usual = heights[heights.size() * 9 / 10];
    return curve.bars || usual <= 0.0 ? heights.back() : std::min(heights.back(), 2.5 * usual);
}

}  // namespace

DensityPicture::DensityPicture(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Density of the distribution"));
}

void DensityPicture::set_distribution(std::optional<Distribution> distribution) {
    distribution_ = std::move(distribution);
    update();
}

void DensityPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(1, 3, -1, -3);
    const QColor ink =
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    if (!distribution_) return;
    const Curve curve = curve_of(*distribution_);
    const double top = ceiling_of(curve);
    if (!(top > 0.0)) return;
    const auto place = [&](double x, double y) {
        return QPointF(area.left() + area.width() * (x - curve.low) / (curve.high - curve.low),
                       area.bottom() - area.height() * std::min(1.0, y / top));
    };
    painter.setPen(QPen(ink, 1.5));
    if (curve.bars) {
        for (const QPointF& point : curve.points)
            painter.drawLine(place(point.x(), 0.0), place(point.x(), point.y()));
        return;
    }
    QPainterPath path(place(curve.low, 0.0));
    for (const QPointF& point : curve.points) path.lineTo(place(point.x(), point.y()));
    path.lineTo(place(curve.high, 0.0));
    QColor ground = ink;
    ground.setAlpha(50);
    painter.fillPath(path, ground);
    painter.drawPath(path);
    const double mean = distribution_->mean();
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
    painter.drawLine(place(mean, 0.0), place(mean, top));
}

}  // namespace covaria::ui
