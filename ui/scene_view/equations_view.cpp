#include "ui/scene_view/equations_view.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/theme/formula_picture.h"
#include "ui/theme/number_locale.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {

constexpr double margin = 28.0, narrow_margin = 10.0;
constexpr double low_pane = 200.0;  // below it the margins are narrow
constexpr double column_gap = 40.0;

/// Equations without a formula are set as the text that they are.
FormulaPicture picture_of(const ModelEquation& equation, const QFont& font) {
    if (equation.formula.empty()) return {equation_text(to_std(to_qt(equation.text))), font};
    return {with_numbers(equation.formula, user_numbers()), font};
}

struct SetEquations {
    std::vector<FormulaPicture> formulas;
    std::vector<QPointF> places;
    QSizeF size;
    QFont font;
    double gap = 0.0;  ///< between two below each other
};

/// Sets equations below each other, in as many columns as the height asks for.
SetEquations set_in_columns(const std::vector<ModelEquation>& equations, const QFont& font, double height) {
    const double gap = std::clamp(0.6 * font.pointSizeF(), 4.0, 10.0);
    SetEquations made{{}, {}, {}, font, gap};
    double x = 0.0, y = 0.0, width = 0.0;
    for (const ModelEquation& equation : equations) {
        FormulaPicture formula = picture_of(equation, font);
        if (y > 0.0 && y + formula.height() > height) {
            x += width + column_gap;
            y = width = 0.0;
        }
        made.places.emplace_back(x, y);
        width = std::max(width, formula.width());
        made.size = made.size.expandedTo({x + width, y + formula.height()});
        y += formula.height() + gap;
        made.formulas.push_back(std::move(formula));
    }
    return made;
}

/// Sets equations at the wanted size, or smaller if they do not fit into the room.
SetEquations fitted(const std::vector<ModelEquation>& equations, QFont font, QSizeF room) {
    SetEquations made;
    for (const double size : {16.0, 14.0, 12.0, 10.5, 9.0, 8.0, 7.0}) {
        font.setPointSizeF(size);
        made = set_in_columns(equations, font, room.height());
        if (made.size.width() <= room.width() && made.size.height() <= room.height()) break;
    }
    return made;
}

}  // namespace

EquationsView::EquationsView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Equations"));
}

void EquationsView::show_equations(const QString& title, std::vector<ModelEquation> equations) {
    title_ = title;
    equations_ = std::move(equations);
    QStringList words;
    for (const ModelEquation& equation : equations_) words << to_qt(equation.text);
    setAccessibleDescription(words.join(QLatin1Char('\n')));
    update();
}

void EquationsView::put_tools(QWidget& tools) {
    tools_ = &tools;
    tools.setParent(this);
    tools.installEventFilter(this);
    tools.show();
    place_tools();
}

bool EquationsView::eventFilter(QObject* tools, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) place_tools();
    return QWidget::eventFilter(tools, event);
}

void EquationsView::place_tools() {
    if (!tools_) return;
    const QSize size = tools_->sizeHint();
    tools_->setGeometry(width() - size.width() - int(narrow_margin), 4, size.width(), size.height());
}

int EquationsView::height_wanted(int width) const {
    const double line = QFontMetricsF(font()).height();
    const double around = 2.0 * narrow_margin + 1.4 * line + 4.0;
    const double room = width - 2.0 * margin;
    SetEquations set = fitted(equations_, font(), {room, low_pane - around});
    double tallest = 0.0;
    for (const FormulaPicture& formula : set.formulas) tallest = std::max(tallest, formula.height());
    for (std::size_t rows = 1; rows < set.formulas.size(); ++rows) {  // beside each other as far as they fit
        SetEquations lower = set_in_columns(equations_, set.font, double(rows) * (tallest + set.gap));
        if (lower.size.width() > room || lower.size.height() >= set.size.height()) continue;
        set = std::move(lower);
        break;
    }
    return std::max(minimumSizeHint().height(), int(std::ceil(set.size.height() + around)));
}

void EquationsView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QColor ink = palette().color(QPalette::Text);
    QFont head = font();
    head.setWeight(QFont::DemiBold);
    painter.setFont(head);
    painter.setPen(mix(palette().color(QPalette::Base), ink, 0.7));
    const double line = QFontMetricsF(head).height();
    const double above = height() < low_pane ? narrow_margin : margin;
    painter.drawText(QRectF(margin, above, width() - 2.0 * margin, line), Qt::AlignLeft, title_);
    const QPointF top(margin, above + (height() < low_pane ? 1.4 : 2.0) * line);
    const QSizeF room(width() - 2.0 * margin, height() - top.y() - above);
    const SetEquations set = fitted(equations_, font(), room);
    for (std::size_t i = 0; i < set.formulas.size(); ++i)
        set.formulas[i].paint(painter, top + set.places[i], ink);
}

}  // namespace covaria::ui
