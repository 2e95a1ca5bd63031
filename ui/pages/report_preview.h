// The report, or the certificate, as it would be printed, page under page.
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "ui/document/document.h"
#include "ui/export/report_maker.h"
#include "ui/print/report_pages.h"
#include "ui/run/analysis_runner.h"

class QComboBox;
class QLabel;

namespace covaria::ui {

class PageBar;
class PageList;
class PageView;

/// Made when it is looked at; says so when results or project have changed since.
class ReportPreview : public QWidget {
    Q_OBJECT
public:
    ReportPreview(Document& document, AnalysisRunner& runner, QWidget* parent = nullptr);

    void refresh();
    /// Begins anew with another project: no page of the former one stays.
    void start_over();
    DocumentKind kind() const;
    bool is_busy() const { return maker_.is_busy(); }
    std::size_t page_count() const { return pages_.size(); }
    /// Pages as pictures at 96 dots an inch, the same as the pages of the PDF.
    const std::vector<QImage>& pages() const { return pages_; }
    PageView& view() { return *view_; }

signals:
    /// The kind of document in view; the report, too, when neither is looked at any more.
    void in_view(DocumentKind kind);

protected:
    void hideEvent(QHideEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QLayout* make_head();
    void say(const QString& words);
    void compare_with_present();
    QString kind_words() const;
    QString page_words() const;
    void show_pages(const std::vector<PrintedPage>& pages, const std::vector<QImage>& images);

    Document& document_;
    AnalysisRunner& runner_;
    bool old_ = true;
    ProjectSnapshot made_of_;  ///< null: not made
    QStringList parts_;        ///< the parts of made_of_, to be compared
    bool waiting_ = false;     ///< waits for the project as it is now to be made
    std::vector<QImage> pages_;
    QComboBox* kind_;
    QLabel* state_;
    PageList* list_;
    PageView* view_;
    PageBar* bar_;
    ReportMaker maker_;
};

}  // namespace covaria::ui
