#include "ui/pages/seen_delegate.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/evidence/seen.h"
#include "ui/models/seen_table_model.h"
#include "ui/theme/fonts.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
namespace {

using evidence::Verdict;

constexpr int scale_width = 220, chip_room = 8;  // px
constexpr double most_doublings = 3.0;           // half width of the scale

QColor ink_of(Verdict verdict, const Tokens& tokens) {
    if (verdict == Verdict::larger) return tokens.red;
    return verdict == Verdict::too_little ? tokens.ink3 : tokens.ink;
}

/// The cell's ground without its text.
void draw_ground(QPainter& painter, QStyleOptionViewItem option) {
    option.text.clear();
    const QStyle* style = option.widget ? option.widget->style() : nullptr;
    if (style) style->drawControl(QStyle::CE_ItemViewItem, &option, &painter, option.widget);
}

class Scale {
public:
    explicit Scale(const QRectF& cell) : cell_(cell.adjusted(12, 0, -12, 0)) {}
    double x(double factor) const {
        const double doublings =
            std::clamp(std::log2(std::max(factor, 1e-300)), -most_doublings, most_doublings);
        return cell_.left() + cell_.width() * (doublings + most_doublings) / (2 * most_doublings);
    }
    static bool holds(double factor) {
        return factor > std::exp2(-most_doublings) && factor < std::exp2(most_doublings);
    }

private:
    QRectF cell_;
};

/// A cap, or an arrow where the interval goes on beyond the scale.
void draw_end(QPainter& painter, QPointF at, double outwards, bool is_cut) {
    if (!is_cut) return painter.drawLine(at - QPointF(0, 4), at + QPointF(0, 4));
    painter.drawLine(at, at + QPointF(-5 * outwards, -4));
    painter.drawLine(at, at + QPointF(-5 * outwards, 4));
}

void draw_interval(QPainter& painter, const QRectF& cell, const QList<double>& interval, Verdict verdict,
                   const Tokens& tokens) {
    const Scale scale(cell);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0}) {
        painter.setPen(QPen(factor == 1.0 ? tokens.line2 : tokens.line, factor == 1.0 ? 1.5 : 1.0));
        painter.drawLine(QPointF(scale.x(factor), cell.top()), QPointF(scale.x(factor), cell.bottom()));
    }
    const QColor ink = ink_of(verdict, tokens);
    const double y = cell.center().y();
    const QPointF low(scale.x(interval[0]), y), high(scale.x(interval[2]), y);
    painter.setPen(QPen(ink, 1.5));
    painter.drawLine(low, high);
    draw_end(painter, low, -1.0, !Scale::holds(interval[0]));
    draw_end(painter, high, 1.0, !Scale::holds(interval[2]));
    painter.setBrush(verdict == Verdict::too_little ? tokens.stage : ink);
    painter.drawEllipse(QPointF(scale.x(interval[1]), y), 4, 4);
}

void draw_verdict(QPainter& painter, const QStyleOptionViewItem& option, const QString& words,
                  Verdict verdict) {
    const Tokens& tokens = tokens_of(option.palette);
    QFont font = sized(option.font, TextSize::small);
    font.setWeight(QFont::DemiBold);
    const QFontMetricsF metrics(font);
    const double width = metrics.horizontalAdvance(words) + 2 * chip_room, height = metrics.height() + 4;
    const QRectF chip(option.rect.left() + 6, option.rect.center().y() - height / 2 + 0.5, width, height);
    const bool agrees = verdict == Verdict::agrees, larger = verdict == Verdict::larger;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(agrees ? tokens.green_tint : larger ? tokens.red_tint : tokens.hover);
    painter.drawRoundedRect(chip, height / 2, height / 2);
    painter.setFont(font);
    painter.setPen(agrees ? tokens.green : larger ? tokens.red : tokens.ink2);
    painter.drawText(chip, Qt::AlignCenter, words);
}

}  // namespace

void SeenDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    const QVariant interval = index.data(SeenTableModel::interval_role),
                   verdict = index.data(SeenTableModel::verdict_role);
    if (!interval.isValid() && !verdict.isValid()) return TypesetDelegate::paint(painter, option, index);
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    draw_ground(*painter, ground);
    painter->save();
    painter->setClipRect(option.rect);
    if (verdict.isValid()) {
        draw_verdict(*painter, option, index.data().toString(), static_cast<Verdict>(verdict.toInt()));
    } else {
        const auto ends = interval.value<QList<double>>();
        draw_interval(*painter, QRectF(option.rect), ends, static_cast<Verdict>(int(ends[3])),
                      tokens_of(option.palette));
    }
    painter->restore();
}

QSize SeenDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QSize size = TypesetDelegate::sizeHint(option, index);
    if (index.data(SeenTableModel::interval_role).isValid()) size.setWidth(scale_width);
    if (index.data(SeenTableModel::verdict_role).isValid()) size.rwidth() += 2 * chip_room + 12;
    return size;
}

}  // namespace covaria::ui
