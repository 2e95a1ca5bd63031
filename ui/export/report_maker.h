// A report made ready without holding up the window: built, laid out and written in a worker; only its
// charts, which belong to the window's thread, are painted there, one per turn of the event loop.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/report/report.h"
#include "ui/export/scene_pictures.h"
#include "ui/jobs/latest_job.h"
#include "ui/print/report_layout.h"

namespace covaria::ui {

/// The painters of figures in reports, the same for window, preview and command line. For the thread that
/// charts belong to.
FigurePainters report_painters(ScenePictures& scenes);

class ReportMaker : public QObject {
    Q_OBJECT
public:
    explicit ReportMaker(QObject* parent = nullptr);

    /// Called in the worker with the document; returns what is then called on the window's
    /// thread. When `stop` is requested charts stay empty: what was made until then must not be used.
    using Use = std::function<JobQueue::Delivery(
        const ReportDocument& document, const FigurePainters& painters, const std::stop_token& stop)>;
    /// `failure`: what is done on the window's thread when there was no memory for it.
    /// A newer request takes the place of one that is still being made.
    struct Source {
        DocumentKind kind;
        MadeProject::Pointer made;
        std::vector<EvaluatedAnalysis> analyses;
        std::vector<FailedAnalysis> failed;
    };
    void make(Source source, Use use, JobQueue::Failure failure);
    bool is_busy() const { return job_.is_busy(); }
    /// Gives up what is being made.
    void cancel() { job_.cancel(); }

private:
    LatestJob job_;
};

}  // namespace covaria::ui
