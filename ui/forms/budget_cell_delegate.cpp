#include "ui/forms/budget_cell_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "ui/models/budget_sheet_model.h"
#include "ui/models/roles.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

constexpr double bar_width = 32.0, bar_height = 8.0, sketch_width = 22.0, sketch_height = 12.0;  // px
constexpr int beside = 8;  // px at both sides of a bar or a sketch

/// Height of the density, 0 to 1, at the place -1 to 1.
using Density = double (*)(double);

struct Sketch {
    std::string_view title;
    Density density;
};

double bell(double t) {
    return std::exp(-4.5 * t * t);
}

constexpr std::array sketches{
    Sketch{"normal", bell},
    Sketch{"Student t", bell},
    Sketch{"rectangular", [](double t) { return std::abs(t) < 0.8 ? 1.0 : 0.0; }},
    Sketch{"curvilinear trapezoid",
           [](double t) { return std::clamp((0.95 - std::abs(t)) / 0.3, 0.0, 1.0); }},
    Sketch{"trapezoidal", [](double t) { return std::clamp((0.95 - std::abs(t)) / 0.45, 0.0, 1.0); }},
    Sketch{"triangular", [](double t) { return std::max(0.0, 1.0 - std::abs(t) / 0.9); }},
    Sketch{"arc sine",
           [](double t) { return std::abs(t) < 0.9 ? 0.2 / std::sqrt(1.0 - t * t / 0.84) : 0.0; }},
    Sketch{"exponential", [](double t) { return t < -0.8 ? 0.0 : std::exp(-2.0 * (t + 0.8)); }},
};

Density density_of(const QModelIndex& index) {
    const std::string title = to_std(index.data(shape_role).toString());
    const auto found = std::ranges::find(sketches, std::string_view(title), &Sketch::title);
    return found == sketches.end() ? nullptr : found->density;
}

void draw_sketch(QPainter& painter, Density density, const QRectF& area, const QColor& colour) {
    constexpr int steps = 44;
    QPainterPath path;
    for (int i = 0; i <= steps; ++i) {
        const double t = 2.0 * i / steps - 1.0;
        const double height = std::clamp(density(t), 0.0, 1.0);
        const QPointF at(area.left() + area.width() * i / steps, area.bottom() - area.height() * height);
        i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void draw_bar(QPainter& painter, double fraction, const QRectF& area, const QColor& colour,
              const QColor& ground) {
    painter.fillRect(area, ground);
    painter.fillRect(
        QRectF(area.topLeft(), QSizeF(area.width() * std::clamp(fraction, 0.0, 1.0), area.height())), colour);
}

void draw_hint(QPainter& painter, const QString& hint, const QStyleOptionViewItem& option) {
    painter.save();
    painter.setPen(tokens_of(option.palette).ink3);
    painter.setFont(option.font);
    const QRect area = option.rect.adjusted(beside / 2, 0, 0, 0);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                     option.fontMetrics.elidedText(hint, Qt::ElideRight, area.width()));
    painter.restore();
}

}  // namespace

void BudgetCellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
    const Density density = density_of(index);
    const QVariant fraction = index.data(fraction_role);
    if (!density) CellDelegate::paint(painter, option, index);
    if (const QString hint = index.data(hint_role).toString(); !hint.isEmpty())
        draw_hint(*painter, hint, option);
    if (!density && !fraction.isValid()) return;
    const Tokens& tokens = tokens_of(option.palette);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const double left = option.rect.left() + beside, middle = QRectF(option.rect).center().y();
    if (density) {
        QStyleOptionViewItem cell(option);
        initStyleOption(&cell, index);
        cell.text.clear();
        const QStyle* style = cell.widget ? cell.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
        draw_sketch(*painter, density, {left, middle - sketch_height / 2.0, sketch_width, sketch_height},
                    tokens.orange);
    } else {
        const bool is_type_a =
            index.siblingAtColumn(BudgetSheetModel::type).data().toString() == QLatin1String("A");
        draw_bar(*painter, fraction.toDouble(), {left, middle - bar_height / 2.0, bar_width, bar_height},
                 is_type_a ? tokens.type_a : tokens.orange, tokens.line);
    }
    painter->restore();
}

QSize BudgetCellDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QSize size = CellDelegate::sizeHint(option, index);
    if (density_of(index)) size.setWidth(int(sketch_width) + 2 * beside);
    if (index.data(fraction_role).isValid()) size.rwidth() += int(bar_width) + beside;
    return size;
}

}  // namespace covaria::ui
