// Renders scenes in a thread of its own, so that the window never waits for a picture.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "viz/scene/scene.h"
#include "viz/vtk/scene_renderer.h"

namespace covaria::ui {

class RenderService : public QObject {
    Q_OBJECT
public:
    explicit RenderService(QObject* parent = nullptr);
    ~RenderService() override;

    /// Something to do to the renderer before the next picture. Steps that arrive while a picture is being
    /// made are done together before the next one: the view never lags behind the mouse.
    using Step = std::function<void(SceneRenderer&)>;
    /// Does the step and makes a picture. After a `moving` picture a `full` one follows by itself when the
    /// steps pause.
    void post(Step step, RenderQuality quality = RenderQuality::full);
    /// The item under a pixel; answered by `picked`.
    void pick(double x, double y);
    /// A picture of another size for copying and saving, without disturbing the view; answered by
    /// `picture_made`.
    void make_picture(QSize size);
    /// Blocks until nothing is left to do: for tests.
    void wait_until_idle();

signals:
    void rendered(const QImage& image, const covaria::Camera& camera);
    void picked(const QString& item_id);
    void picture_made(const QImage& image);
    void failed(const QString& message);

private:
    struct Job {
        Step step;
        RenderQuality quality = RenderQuality::full;
        bool wants_image = false;
    };
    void work(const std::stop_token& stop);
    void do_jobs(std::vector<Job> jobs);
    void render(RenderQuality quality);
    void enqueue(Job job);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::vector<Job> queue_;
    bool busy_ = false;
    bool needs_full_ = false;  ///< the last picture was a `moving` one
    SceneRenderer renderer_;   ///< used by the worker only
    std::jthread worker_;      ///< last member: stops before the others go
};

/// The same pixels as a QImage that owns its memory.
QImage to_qimage(const Image& image);

}  // namespace covaria::ui
