#include "ui/export/report_maker.h"

#include <condition_variable>
#include <mutex>

#include "ui/charts/chart_painter.h"
#include "ui/theme/theme.h"

namespace covaria::ui {

namespace {

/// Lets the thread of `window` do something and waits for it, unless stopped: then it is not done any more.
void do_on_window(QObject* window, const std::stop_token& stop, const std::function<void()>& what) {
    struct Ticket {
        std::mutex mutex;
        std::condition_variable_any changed;
        bool done = false, given_up = false;
    };
    auto ticket = std::make_shared<Ticket>();
    QMetaObject::invokeMethod(
        window,
        [ticket, what] {
            const std::lock_guard lock(ticket->mutex);
            if (ticket->given_up) return;
            what();
            ticket->done = true;
            ticket->changed.notify_all();
        },
        Qt::QueuedConnection);
    std::unique_lock lock(ticket->mutex);
    ticket->given_up = !ticket->changed.wait(lock, stop, [&] { return ticket->done; });
}

}  // namespace

FigurePainters report_painters(ScenePictures& scenes) {
    return {[theme = Theme::light()](QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
                paint_plot(painter, area, plot, theme);
            },
            [&scenes](const SceneBlock& block, QSize size) { return scenes.render(block, size); }};
}

ReportMaker::ReportMaker(QObject* parent) : QObject(parent), jobs_(this, Execution::threads) {}

ReportMaker::~ReportMaker() {
    stop_.request_stop();
}

void ReportMaker::cancel() {
    ++number_;
    stop_.request_stop();
    busy_ = false;
}

void ReportMaker::make(std::shared_ptr<const Project> project, std::vector<EvaluatedAnalysis> analyses,
                       Use use, JobQueue::Failure failure) {
    cancel();
    busy_ = true;
    stop_ = std::stop_source();
    const auto deliver = [this, number = number_](const JobQueue::Delivery& done) {
        if (number != number_) return;
        busy_ = false;
        if (done) done();
    };
    jobs_.push(
        [this, deliver, stop = stop_.get_token(), project = std::move(project),
         analyses = std::move(analyses), use = std::move(use)]() -> JobQueue::Delivery {
            if (stop.stop_requested()) return {};
            Problems known;  // those of assets stand in the problems list; an asset that cannot be made is
                             // not in the report
            const AssetLibrary assets = make_assets(*project, known);
            const ReportDocument document = build_report(*project, assets, analyses);
            ScenePictures scenes(analyses);
            FigurePainters painters = report_painters(scenes);
            painters.paint_plot = [this, stop, paint = painters.paint_plot](
                                      QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
                do_on_window(this, stop, [&] { paint(painter, area, plot); });
            };
            const JobQueue::Delivery done = use(document, painters, stop);
            return [deliver, done] { deliver(done); };
        },
        [deliver, failure = std::move(failure)](const Error& error) { deliver([&] { failure(error); }); });
}

}  // namespace covaria::ui
