// The pages of a report as a list: small pictures, numbers, and the headings that begin on each.
#pragma once

#include <QListView>
#include <QStandardItemModel>
#include <vector>

#include "ui/print/report_pages.h"

namespace covaria::ui {

class PageList : public QListView {
    Q_OBJECT
public:
    explicit PageList(QWidget* parent = nullptr);

    void set_pages(const std::vector<PrintedPage>& pages, const std::vector<QImage>& pictures);
    /// Marks the page that is looked at, without a signal.
    void show_page(int page);
    QSize sizeHint() const override;

signals:
    void page_wanted(int page);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    QStandardItemModel pages_;
};

}  // namespace covaria::ui
