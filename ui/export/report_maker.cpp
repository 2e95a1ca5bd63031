#include "ui/export/report_maker.h"

#include <condition_variable>
#include <mutex>

#include "ui/charts/chart_painter.h"
#include "ui/theme/document_language.h"
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
    return {[theme = Theme::light().with_numbers(scenes.language().numbers())](
                QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
                paint_plot(painter, area, plot, theme);
            },
            [&scenes](const SceneBlock& block, QSize size) { return scenes.render(block, size); }};
}

ReportMaker::ReportMaker(QObject* parent) : QObject(parent), job_(Execution::threads) {}

void ReportMaker::make(Source source, Use use, JobQueue::Failure failure) {
    job_.cancel();
    job_.start(
        [this, source = std::move(source),
         use = std::move(use)](const std::stop_token& stop) -> JobQueue::Delivery {
            const ReportDocument document =
                build_document(source.kind, *source.made, source.analyses, source.failed, false,
                               document_language(source.made->project()));
            const ReportSource evaluated{*source.made, source.analyses, source.failed};
            ScenePictures scenes(evaluated);
            FigurePainters painters = report_painters(scenes);
            painters.paint_plot = [this, stop, paint = painters.paint_plot](
                                      QPainter& painter, const QRectF& area, const PlotSpecification& plot) {
                do_on_window(this, stop, [&] { paint(painter, area, plot); });
            };
            return use(document, painters, stop);
        },
        std::move(failure));
}

}  // namespace covaria::ui
