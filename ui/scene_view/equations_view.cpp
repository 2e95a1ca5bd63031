#include "ui/scene_view/equations_view.h"

#include <QPainter>
#include <algorithm>

#include "ui/theme/formula_picture.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {

constexpr double margin = 28.0;

/// Equations without a formula are set as the text that they are.
FormulaPicture picture_of(const ModelEquation& equation, const QFont& font) {
    if (equation.formula.empty()) return {equation_text(equation.text), font};
    return {equation.formula, font};
}

/// At the wanted size, or smaller if they do not fit into the room.
std::vector<FormulaPicture> fitted(const std::vector<ModelEquation>& equations, QFont font, QSizeF room) {
    std::vector<FormulaPicture> formulas;
    for (const double size : {16.0, 14.0, 12.0, 10.5, 9.0, 8.0, 7.0}) {
        font.setPointSizeF(size);
        formulas.clear();
        double widest = 0.0, height = 0.0;
        for (const ModelEquation& equation : equations) {
            formulas.push_back(picture_of(equation, font));
            widest = std::max(widest, formulas.back().width());
            height += formulas.back().height() + size;
        }
        if (widest <= room.width() && height <= room.height()) break;
    }
    return formulas;
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

void EquationsView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QColor ink = palette().color(QPalette::Text);
    QFont head = font();
    head.setWeight(QFont::DemiBold);
    painter.setFont(head);
    painter.setPen(mix(palette().color(QPalette::Base), ink, 0.7));
    const double line = QFontMetricsF(head).height();
    painter.drawText(QRectF(margin, margin, width() - 2.0 * margin, line), Qt::AlignLeft, title_);
    const double top = margin + 2.0 * line;
    const QSizeF room(width() - 2.0 * margin, height() - top - margin);
    const auto formulas = fitted(equations_, font(), room);
    double total = 0.0;
    for (const FormulaPicture& formula : formulas) total += formula.height();
    const double gap =
        formulas.empty() ? 0.0 : std::clamp((room.height() - total) / double(formulas.size() + 1), 6.0, 22.0);
    double y = top;
    for (const FormulaPicture& formula : formulas) {
        formula.paint(painter, QPointF(margin, y), ink);
        y += formula.height() + gap;
    }
}

}  // namespace covaria::ui
