#include "ui/pages/report_preview.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/forms/finish_typing.h"
#include "ui/pages/current_results.h"
#include "ui/print/report_pages.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int preview_dots_per_inch = 96;

/// A page, as wide as there is room, but no wider than it was made.
class Sheet : public QWidget {
public:
    explicit Sheet(const QImage& image) : image_(image) {
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }
    QSize sizeHint() const override { return shown(image_.width()); }
    QSize minimumSizeHint() const override { return {200, 100}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return shown(width).height(); }

protected:
    void paintEvent(QPaintEvent*) override {
        const QSize size = shown(width());
        const QRect place(QPoint((width() - size.width()) / 2, 0), size);
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, image_);
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawRect(place.adjusted(0, 0, -1, -1));
    }

private:
    QSize shown(int room) const {
        const int width = std::min(room, image_.width());
        return {width, int(std::lround(double(width) * image_.height() / image_.width()))};
    }
    QImage image_;
};

}  // namespace

ReportPreview::ReportPreview(Document& document, AnalysisRunner& runner, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner) {
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 4, 8, 4);
    state_ = new QLabel(tr("The report has not been made yet."));
    auto* update = new QPushButton(tr("Update"));
    head->addWidget(state_, 1);
    head->addWidget(update);
    area_ = new QScrollArea;
    area_->setFrameShape(QFrame::NoFrame);
    area_->setWidgetResizable(true);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area_->setBackgroundRole(QPalette::AlternateBase);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(head);
    column->addWidget(area_, 1);
    connect(update, &QPushButton::clicked, this, [this] {
        finish_typing();
        refresh();
    });
    connect(&document_, &Document::project_changed, this, &ReportPreview::mark_old);
    connect(&runner_, &AnalysisRunner::result_changed, this, &ReportPreview::mark_old);
    connect(&runner_, &AnalysisRunner::idle, this, [this] {
        if (isVisible() && old_ && pages_.empty() && !maker_.is_busy()) refresh();
    });
}

void ReportPreview::mark_old() {
    old_ = true;
    if (!pages_.empty()) state_->setText(tr("Out of date: the project or its results have changed since."));
}

void ReportPreview::showEvent(QShowEvent*) {
    if (old_ && pages_.empty()) refresh();
}

void ReportPreview::start_over() {
    maker_.cancel();
    old_ = true;
    pages_.clear();
    delete area_->takeWidget();
    state_->setText(tr("The report has not been made yet."));
}

void ReportPreview::refresh() {
    const auto results = current_results(document_.project(), runner_);
    if (results.empty()) {
        state_->setText(runner_.is_busy() ? tr("The analyses are running: the report waits for them.")
                                          : tr("No analysis is up to date: run one first (F5)."));
        return;
    }
    old_ = false;
    state_->setText(tr("Making the report …"));
    maker_.make(
        runner_.made(), results,
        [this](const ReportDocument& report, const FigurePainters& figures,
               const std::stop_token&) -> JobQueue::Delivery {
            const PdfOptions options{.paint_plot = figures.paint_plot, .render_scene = figures.render_scene};
            return
                [this, images = page_images(report, options, preview_dots_per_inch)] { show_pages(images); };
        },
        [this](const Error& error) {
            old_ = true;
            state_->setText(tr("The report could not be made: %1").arg(to_qt(error.message)));
        });
}

void ReportPreview::show_pages(const std::vector<QImage>& images) {
    auto* sheets = new QWidget;
    auto* column = new QVBoxLayout(sheets);
    column->setSpacing(16);
    for (const QImage& image : images) column->addWidget(new Sheet(image));
    area_->setWidget(sheets);
    pages_ = images;
    if (!old_)
        state_->setText(pages_.size() == 1 ? tr("1 page, as printed")
                                           : tr("%1 pages, as printed").arg(pages_.size()));
}

}  // namespace covaria::ui
