// A report made ready without holding up the window: built, laid out and written in a worker; only its
// charts, which belong to the window's thread, are painted there, one per turn of the event loop.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>

#include "core/project/project.h"
#include "core/report/report.h"
#include "ui/export/scene_pictures.h"
#include "ui/print/report_layout.h"
#include "ui/run/job_queue.h"

namespace covaria::ui {

/// The one way in which figures of reports are drawn: window, preview and command line. For the thread that
/// charts belong to.
FigurePainters report_painters(ScenePictures& scenes);

class ReportMaker : public QObject {
    Q_OBJECT
public:
    explicit ReportMaker(QObject* parent = nullptr);
    ~ReportMaker() override;

    /// In the worker: what is to be done with the report; returns what is then called on the window's thread.
    /// When `stop` is requested charts stay empty: what was made until then must not be used.
    using Use = std::function<JobQueue::Delivery(
        const ReportDocument& document, const FigurePainters& painters, const std::stop_token& stop)>;
    /// `failure`: what is done on the window's thread when there was no memory for it.
    /// A newer request takes the place of one that is still being made.
    void make(std::shared_ptr<const Project> project, std::vector<EvaluatedAnalysis> analyses, Use use,
              JobQueue::Failure failure);
    bool is_busy() const { return busy_; }
    /// Gives up what is being made.
    void cancel();

private:
    bool busy_ = false;
    quint64 number_ = 0;
    std::stop_source stop_;
    JobQueue jobs_;  ///< last member: its thread ends first
};

}  // namespace covaria::ui
