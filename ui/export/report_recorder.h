// A report made ready without holding up the window: built in a worker, its charts recorded on the window's
// thread one per turn of the event loop (charts belong to that thread), and then laid out in the worker.
#pragma once

#include <QObject>
#include <QPicture>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>

#include "core/project/project.h"
#include "core/report/report.h"
#include "ui/print/report_layout.h"
#include "ui/run/job_queue.h"

namespace covaria::ui {

/// A report with its charts recorded: can be laid out on any thread.
struct RecordedReport {
    std::vector<EvaluatedAnalysis> analyses;
    ReportDocument document;
    std::map<std::string, QPicture> plots;
    /// Plays a recorded chart into an area.
    void play(QPainter& painter, const QRectF& area, const PlotSpecification& plot) const;
};

class ReportRecorder : public QObject {
    Q_OBJECT
public:
    explicit ReportRecorder(QObject* parent = nullptr);

    /// In the worker: what is to be done with the finished report; returns what is then called on the
    /// window's thread.
    using Use = std::function<JobQueue::Delivery(const RecordedReport&)>;
    /// A newer request takes the place of one that is still being recorded.
    void record(std::shared_ptr<const Project> project, std::vector<EvaluatedAnalysis> analyses, Use use);
    bool is_busy() const { return busy_; }

private:
    struct Job;
    void record_next(const std::shared_ptr<Job>& job);

    bool busy_ = false;
    quint64 number_ = 0;
    JobQueue jobs_;
};

}  // namespace covaria::ui
