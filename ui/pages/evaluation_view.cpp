#include "ui/pages/evaluation_view.h"

#include <QComboBox>
#include <QEvent>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QTextOption>
#include <QVBoxLayout>

#include "ui/charts/chart_view.h"
#include "ui/forms/form_labels.h"
#include "ui/pages/side_by_side.h"
#include "ui/theme/strings.h"
#include "ui/theme/theme.h"

namespace covaria::ui {
EvaluationView::EvaluationView(Qt::Orientation orientation, QWidget* parent)
    : QWidget(parent),
      text_(new QTextBrowser),
      charts_(new QWidget),
      list_(new QComboBox),
      chart_(new ChartView) {
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenLinks(false);
    text_->document()->setDocumentMargin(10);
    // Wide tables scroll; numbers are never broken.
    text_->setWordWrapMode(QTextOption::WordWrap);
    text_->document()->setDefaultStyleSheet(QStringLiteral("td { white-space: nowrap }"));
    text_->setAccessibleName(tr("Tables of the evaluation"));
    list_->setAccessibleName(tr("Chart"));
    may_be_narrow(*list_);  // the titles of charts are long, and a form's pane is not wide
    list_->setToolTip(tr("Which chart of the evaluation is shown"));
    chart_->setMinimumSize(220, 160);
    auto* column = new QVBoxLayout(charts_);
    column->setContentsMargins(0, 2, 0, 0);
    column->setSpacing(2);
    column->addWidget(list_);
    column->addWidget(chart_, 1);
    QSplitter* splitter =
        orientation == Qt::Horizontal ? side_by_side(text_, charts_) : one_above_other(text_, charts_);
    widen_to_content(*splitter, *text_);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(splitter);
    charts_->hide();
    connect(list_, &QComboBox::currentIndexChanged, this, &EvaluationView::show_chart);
    take_theme();
}

void EvaluationView::show_evaluation(const QString& html, std::vector<PlotSpecification> figures) {
    const int position = text_->verticalScrollBar()->value();
    text_->setVisible(!html.isEmpty());
    text_->setHtml(html);
    text_->verticalScrollBar()->setValue(position);
    figures_ = std::move(figures);
    const QString before = list_->currentData().toString();
    {
        const QSignalBlocker blocker(list_);
        list_->clear();
        for (const PlotSpecification& figure : figures_)
            list_->addItem(to_qt(to_unicode(figure.title)), to_qt(figure.id));
        list_->setCurrentIndex(std::max(0, list_->findData(before)));
    }
    charts_->setVisible(!figures_.empty());
    list_->setVisible(figures_.size() > 1);
    show_chart();
}

void EvaluationView::show_chart() {
    const int index = list_->currentIndex();
    const bool known = index >= 0 && std::size_t(index) < figures_.size();
    chart_->set_plot(known ? figures_[std::size_t(index)] : PlotSpecification{});
}

void EvaluationView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) take_theme();
}

void EvaluationView::take_theme() {
    chart_->set_theme(Theme::of(palette()));
}

}  // namespace covaria::ui
