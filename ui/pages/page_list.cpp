#include "ui/pages/page_list.h"

#include <QIcon>
#include <QImage>
#include <QPixmap>
#include <QSignalBlocker>
#include <QStandardItem>

#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr QSize small_page(51, 72);
constexpr int most_headings = 3;  // beside the picture; all are in the tooltip

}  // namespace

PageList::PageList(QWidget* parent) : QListView(parent) {
    setObjectName(QStringLiteral("report_page_list"));
    setAccessibleName(tr("Pages"));
    setFrameShape(QFrame::NoFrame);
    setIconSize(small_page);
    setEditTriggers(NoEditTriggers);
    setTextElideMode(Qt::ElideRight);
    setUniformItemSizes(true);
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setModel(&pages_);
    connect(this, &QListView::clicked, this,
            [this](const QModelIndex& index) { emit page_wanted(index.row()); });
}

/// The picture, and a heading of usual length beside it.
QSize PageList::sizeHint() const {
    constexpr int digits = 28;
    return {small_page.width() + digits * fontMetrics().horizontalAdvance(QLatin1Char('0')),
            QListView::sizeHint().height()};
}

void PageList::set_pages(const std::vector<PrintedPage>& pages, const std::vector<QImage>& pictures) {
    const QSignalBlocker quiet(this);
    pages_.clear();
    for (std::size_t page = 0; page < pages.size(); ++page) {
        QStringList lines{tr("Page %1").arg(page + 1)};
        for (const std::string& heading : pages[page].headings) lines << to_qt(heading);
        const QImage small = pictures[page].scaled(small_page * devicePixelRatioF(), Qt::KeepAspectRatio,
                                                   Qt::SmoothTransformation);
        const bool more = lines.size() > 1 + most_headings;
        auto* item = new QStandardItem(QIcon(QPixmap::fromImage(small)),
                                       lines.mid(0, 1 + most_headings).join(QLatin1Char('\n')) +
                                           (more ? QStringLiteral(" …") : QString()));
        item->setToolTip(lines.mid(1).join(QLatin1Char('\n')));
        item->setData(lines.join(QStringLiteral(", ")), Qt::AccessibleTextRole);
        pages_.appendRow(item);
    }
}

void PageList::show_page(int page) {
    const QSignalBlocker quiet(this);
    setCurrentIndex(pages_.index(page, 0));
    if (page >= 0) scrollTo(currentIndex());
}

void PageList::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QListView::currentChanged(current, previous);
    if (current.isValid()) emit page_wanted(current.row());
}

}  // namespace covaria::ui
