#include "ui/pages/report_preview.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/made/certificate_gaps.h"
#include "ui/forms/finish_typing.h"
#include "ui/pages/current_results.h"
#include "ui/pages/page_bar.h"
#include "ui/pages/page_list.h"
#include "ui/pages/page_view.h"
#include "ui/theme/elided_label.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr int preview_dots_per_inch = 96;

/// Results that a document of the project would state of each analysis, as texts to compare.
QStringList parts_of(const Project& project, const AnalysisRunner& runner) {
    QStringList parts;
    for (const AnalysisEntry& analysis : project.analyses) {
        const QString id = to_qt(analysis.id);
        const AnalysisStatus& status = runner.status(id);
        parts << (status.is_current() ? to_qt(status.result_of->fingerprint()) : QString())
              << (status.state == RunState::failed ? status.message : QString());
        if (status.is_current() && runner.kept().before(id, status.result)) parts << QStringLiteral("before");
        for (const Study& study : analysis.studies)
            if (runner.studies().status(id, to_qt(study.id)).is_current()) parts << to_qt(study.id);
        for (const Design& design : analysis.designs)
            if (runner.designs().status(id, to_qt(design.id)).is_current()) parts << to_qt(design.id);
    }
    return parts;
}

}  // namespace

ReportPreview::ReportPreview(Document& document, AnalysisRunner& runner, QWidget* parent)
    : QWidget(parent), document_(document), runner_(runner) {
    view_ = new PageView;
    view_->setAccessibleName(tr("Pages as they are printed"));
    list_ = new PageList;
    bar_ = new PageBar(*view_, *this);
    auto* pages = new QSplitter(Qt::Horizontal);
    pages->setChildrenCollapsible(false);
    pages->addWidget(list_);
    pages->addWidget(view_);
    pages->setStretchFactor(1, 1);
    pages->setSizes({list_->sizeHint().width(), 1000});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(make_head());
    column->addWidget(pages, 1);
    connect(list_, &PageList::page_wanted, view_, &PageView::go_to_page);
    connect(view_, &PageView::current_page_changed, list_, &PageList::show_page);
    connect(&document_, &Document::project_changed, this, &ReportPreview::compare_with_present);
    connect(&runner_, &AnalysisRunner::result_changed, this, &ReportPreview::compare_with_present);
    connect(&runner_.kept(), &KeptStates::changed, this, &ReportPreview::compare_with_present);
    connect(&runner_.studies(), &InquiryRunner::changed, this, &ReportPreview::compare_with_present);
    connect(&runner_.designs(), &InquiryRunner::changed, this, &ReportPreview::compare_with_present);
    connect(&document_.maker(), &ProjectMaker::made_changed, this, [this] {
        if (waiting_) refresh();
    });
    connect(&runner_, &AnalysisRunner::idle, this, [this] {
        if (isVisible() && old_ && pages_.empty() && !maker_.is_busy()) refresh();
    });
    start_over();
}

QLayout* ReportPreview::make_head() {
    auto* head = new QVBoxLayout;
    head->setContentsMargins(8, 4, 8, 4);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    kind_ = new QComboBox;
    kind_->setObjectName(QStringLiteral("document_kind"));
    kind_->setAccessibleName(tr("Document"));
    kind_->setToolTip(
        tr("The document that is shown: the report, the calibration certificate, or a sheet of two "
           "pages for each analysis"));
    for (const auto& [kind, name] : {std::pair(DocumentKind::report, tr("Report")),
                                     std::pair(DocumentKind::certificate, tr("Certificate")),
                                     std::pair(DocumentKind::sheet, tr("Sheet"))})
        kind_->addItem(name, static_cast<int>(kind));
    state_ = new ElidedLabel;
    state_->setObjectName(QStringLiteral("report_state"));
    auto* update = new QPushButton(tr("Update"));
    update->setObjectName(QStringLiteral("update_report"));
    row->addWidget(kind_);
    row->addWidget(bar_);
    row->addStretch(1);
    row->addWidget(update);
    head->addLayout(row);
    head->addWidget(state_);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
        emit in_view(kind());
        start_over();
        refresh();
    });
    connect(update, &QPushButton::clicked, this, [this] {
        finish_typing();
        refresh();
    });
    return head;
}

/// Two lines where there is little room, and all of it in the tooltip.
void ReportPreview::say(const QString& words) {
    state_->setText(words);
    state_->setToolTip(words);
}

DocumentKind ReportPreview::kind() const {
    return static_cast<DocumentKind>(kind_->currentData().toInt());
}

QString ReportPreview::kind_words() const {
    switch (kind()) {
        case DocumentKind::certificate:
            return tr("The certificate");
        case DocumentKind::sheet:
            return tr("The sheet");
        case DocumentKind::report:
            break;
    }
    return tr("The report");
}

/// Saving under another name makes the project anew, and an edit may be undone: both leave it as it was.
void ReportPreview::compare_with_present() {
    if (pages_.empty() && !maker_.is_busy()) return;
    old_ =
        !made_of_ || !(document_.project() == *made_of_) || parts_of(document_.project(), runner_) != parts_;
    if (pages_.empty()) return;
    if (old_)
        say(tr("Out of date: the project or its results have changed since."));
    else if (!maker_.is_busy())
        say(page_words());
}

void ReportPreview::hideEvent(QHideEvent*) {
    emit in_view(DocumentKind::report);
}

void ReportPreview::showEvent(QShowEvent*) {
    emit in_view(kind());
    if (old_ && pages_.empty()) refresh();
}

void ReportPreview::start_over() {
    maker_.cancel();
    waiting_ = false;
    made_of_.reset();
    old_ = true;
    show_pages({}, {});
    say(tr("%1 has not been made yet.").arg(kind_words()));
}

void ReportPreview::refresh() {
    waiting_ = document_.maker().is_making();  // for the project as it is now
    if (waiting_) return;
    ReportMaker::Source source = document_source(kind(), document_.project(), runner_);
    if (source.analyses.empty()) {
        say(runner_.is_busy() ? tr("The analyses are running: %1 waits for them.").arg(kind_words().toLower())
                              : tr("No analysis is up to date: run one first (F5)."));
        return;
    }
    made_of_ = document_.snapshot();
    parts_ = parts_of(*made_of_, runner_);
    old_ = false;
    say(tr("Being made …"));
    maker_.make(
        std::move(source),
        [this](const ReportDocument& report, const FigurePainters& figures,
               const std::stop_token&) -> JobQueue::Delivery {
            const PdfOptions options{.paint_plot = figures.paint_plot, .render_scene = figures.render_scene};
            std::vector<PrintedPage> pages = printed_pages(report, options);
            std::vector<QImage> images;
            for (const PrintedPage& page : pages) images.push_back(page_image(page, preview_dots_per_inch));
            return
                [this, pages = std::move(pages), images = std::move(images)] { show_pages(pages, images); };
        },
        [this](const Error& error) {
            made_of_.reset();
            old_ = true;
            say(tr("%1 could not be made: %2").arg(kind_words(), to_qt(error.message)));
        });
}

void ReportPreview::show_pages(const std::vector<PrintedPage>& pages, const std::vector<QImage>& images) {
    pages_ = images;
    list_->set_pages(pages, images);
    view_->set_pages(pages);
    bar_->take_pages();
    list_->show_page(view_->current_page());
    if (!old_) say(page_words());
}

QString ReportPreview::page_words() const {
    const QString pages =
        pages_.size() == 1 ? tr("1 page, as printed") : tr("%1 pages, as printed").arg(pages_.size());
    const auto& made = document_.maker().made();
    const auto missing =
        made ? certificate_gaps(*made, certified_ids(made->project())).size() : std::size_t{0};
    if (kind() != DocumentKind::certificate || missing == 0) return pages;
    return missing == 1 ? tr("%1; one required text is not stated").arg(pages)
                        : tr("%1; %2 required texts are not stated").arg(pages).arg(missing);
}

}  // namespace covaria::ui
