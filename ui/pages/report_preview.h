// The report as it would be printed, page under page.
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "ui/document/document.h"
#include "ui/export/report_recorder.h"
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
    bool is_busy() const { return recorder_.is_busy(); }
    std::size_t page_count() const { return pages_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void mark_old();
    void show_pages(const std::vector<QImage>& images);

    Document& document_;
    AnalysisRunner& runner_;
    bool old_ = true;
    std::size_t pages_ = 0;
    QLabel* state_;
    QScrollArea* area_;
    ReportRecorder recorder_;
};

}  // namespace covaria::ui
