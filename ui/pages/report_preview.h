// The report as it would be printed, page under page.
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "ui/document/document.h"
#include "ui/export/report_maker.h"
#include "ui/run/analysis_runner.h"

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace covaria::ui {

/// Made when it is looked at; says so when results or project have changed since.
class ReportPreview : public QWidget {
    Q_OBJECT
public:
    ReportPreview(Document& document, AnalysisRunner& runner, QWidget* parent = nullptr);

    void refresh();
    /// Another project: no page of the former one stays.
    void start_over();
    bool is_busy() const { return maker_.is_busy(); }
    std::size_t page_count() const { return pages_.size(); }
    /// As they are shown; the same as the pages of the PDF.
    const std::vector<QImage>& pages() const { return pages_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void mark_old();
    void show_pages(const std::vector<QImage>& images);

    Document& document_;
    AnalysisRunner& runner_;
    bool old_ = true;
    std::vector<QImage> pages_;
    QLabel* state_;
    QScrollArea* area_;
    ReportMaker maker_;
};

}  // namespace covaria::ui
