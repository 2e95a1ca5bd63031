#include "ui/pages/report_preview.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
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
constexpr QSize small_page(51, 72);

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
    area_ = new QScrollArea;
    area_->setFrameShape(QFrame::NoFrame);
    area_->setWidgetResizable(true);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area_->setBackgroundRole(QPalette::AlternateBase);
    list_ = new QListWidget;
    list_->setAccessibleName(tr("Pages"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setIconSize(small_page);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFixedWidth(small_page.width() + 3 * list_->fontMetrics().horizontalAdvance(QLatin1Char('0')) +
                         list_->verticalScrollBar()->sizeHint().width() + 24);
    auto* pages = new QHBoxLayout;
    pages->setSpacing(0);
    pages->addWidget(list_);
    pages->addWidget(area_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(make_head());
    column->addLayout(pages, 1);
    connect(list_, &QListWidget::currentRowChanged, this, &ReportPreview::go_to_page);
    connect(area_->verticalScrollBar(), &QScrollBar::valueChanged, this, &ReportPreview::show_page_of);
    connect(&document_, &Document::project_changed, this, &ReportPreview::mark_old);
    connect(&runner_, &AnalysisRunner::result_changed, this, &ReportPreview::mark_old);
    connect(&runner_.kept(), &KeptStates::changed, this, &ReportPreview::mark_old);
    connect(&document_.maker(), &ProjectMaker::made_changed, this, [this] {
        if (waiting_) refresh();
    });
    connect(&runner_, &AnalysisRunner::idle, this, [this] {
        if (isVisible() && old_ && pages_.empty() && !maker_.is_busy()) refresh();
    });
    start_over();
}

QLayout* ReportPreview::make_head() {
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 4, 8, 4);
    head->setSpacing(8);
    kind_ = new QComboBox;
    kind_->setObjectName(QStringLiteral("document_kind"));
    kind_->setAccessibleName(tr("Document"));
    kind_->setToolTip(tr("What is shown: the report, or the calibration certificate"));
    kind_->addItems({tr("Report"), tr("Certificate")});
    state_ = new QLabel;
    state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* update = new QPushButton(tr("Update"));
    head->addWidget(kind_);
    head->addWidget(state_, 1);
    head->addWidget(update);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
        start_over();
        refresh();
    });
    connect(update, &QPushButton::clicked, this, [this] {
        finish_typing();
        refresh();
    });
    return head;
}

DocumentKind ReportPreview::kind() const {
    return kind_->currentIndex() == 0 ? DocumentKind::report : DocumentKind::certificate;
}

QString ReportPreview::kind_words() const {
    return kind() == DocumentKind::report ? tr("The report") : tr("The certificate");
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
    waiting_ = false;
    old_ = true;
    pages_.clear();
    list_->clear();
    delete area_->takeWidget();
    state_->setText(tr("%1 has not been made yet.").arg(kind_words()));
}

void ReportPreview::refresh() {
    waiting_ = document_.maker().is_making();  // for the project of now
    if (waiting_) return;
    ReportMaker::Source source = document_source(kind(), document_.project(), runner_);
    if (source.analyses.empty()) {
        state_->setText(runner_.is_busy()
                            ? tr("The analyses are running: %1 waits for them.").arg(kind_words().toLower())
                            : tr("No analysis is up to date: run one first (F5)."));
        return;
    }
    old_ = false;
    state_->setText(tr("%1 is being made …").arg(kind_words()));
    maker_.make(
        std::move(source),
        [this](const ReportDocument& report, const FigurePainters& figures,
               const std::stop_token&) -> JobQueue::Delivery {
            const PdfOptions options{.paint_plot = figures.paint_plot, .render_scene = figures.render_scene};
            return
                [this, images = page_images(report, options, preview_dots_per_inch)] { show_pages(images); };
        },
        [this](const Error& error) {
            old_ = true;
            state_->setText(tr("%1 could not be made: %2").arg(kind_words(), to_qt(error.message)));
        });
}

void ReportPreview::show_pages(const std::vector<QImage>& images) {
    auto* sheets = new QWidget;
    auto* column = new QVBoxLayout(sheets);
    column->setSpacing(16);
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const QImage& image : images) {
        column->addWidget(new Sheet(image));
        const QImage small =
            image.scaled(small_page * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
        list_->addItem(new QListWidgetItem(QPixmap::fromImage(small), QString::number(list_->count() + 1)));
    }
    area_->setWidget(sheets);
    pages_ = images;
    list_->setCurrentRow(0);
    if (!old_) state_->setText(page_words());
}

QString ReportPreview::page_words() const {
    const QString pages =
        pages_.size() == 1 ? tr("1 page, as printed") : tr("%1 pages, as printed").arg(pages_.size());
    const auto missing = missing_in(document_.project().certificate).items().size();
    if (kind() == DocumentKind::report || missing == 0) return pages;
    return missing == 1 ? tr("%1; one required text is not stated").arg(pages)
                        : tr("%1; %2 required texts are not stated").arg(pages).arg(missing);
}

void ReportPreview::go_to_page(int page) {
    const QLayout* sheets = area_->widget() ? area_->widget()->layout() : nullptr;
    if (!sheets || page < 0 || page >= sheets->count()) return;
    area_->verticalScrollBar()->setValue(sheets->itemAt(page)->geometry().top());
}

/// The list follows what is scrolled to.
void ReportPreview::show_page_of(int position) {
    const QLayout* sheets = area_->widget() ? area_->widget()->layout() : nullptr;
    if (!sheets) return;
    int page = 0;
    while (page + 1 < sheets->count() && sheets->itemAt(page + 1)->geometry().top() <= position + 8) ++page;
    const QSignalBlocker quiet(list_);
    if (position < area_->verticalScrollBar()->maximum()) list_->setCurrentRow(page);
}

}  // namespace covaria::ui
