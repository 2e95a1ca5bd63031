#include "ui/scene_view/render_service.h"

#include <chrono>

#include "core/base/guarded.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {
constexpr auto pause_before_full_picture = std::chrono::milliseconds(180);
}

QImage to_qimage(const Image& image) {
    return QImage(image.rgba.data(), image.width, image.height, image.width * 4, QImage::Format_RGBA8888)
        .copy();
}

RenderService::RenderService(QObject* parent)
    : QObject(parent), worker_([this](const std::stop_token& stop) { work(stop); }) {}

RenderService::~RenderService() = default;

void RenderService::enqueue(Job job) {
    {
        const std::lock_guard lock(mutex_);
        queue_.push_back(std::move(job));
    }
    changed_.notify_all();
}

void RenderService::post(Step step, RenderQuality quality) {
    enqueue({std::move(step), quality, true});
}

void RenderService::pick(double x, double y) {
    enqueue({[this, x, y](SceneRenderer& renderer) {
        emit picked(QString::fromStdString(renderer.pick(x, y).value_or("")));
    }});
}

void RenderService::make_picture(QSize size) {
    enqueue({[this, size](SceneRenderer& renderer) {
        SceneRenderer other;
        other.set_size(size.width(), size.height());
        other.set_layers(renderer.layers());
        other.set_scene(renderer.scene());
        other.set_camera(renderer.camera());
        other.set_measure(renderer.measure());
        if (const auto image = other.render(RenderQuality::fine))
            emit picture_made(to_qimage(*image));
        else
            emit failed(to_qt(image.error().message));
    }});
}

void RenderService::wait_until_idle() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return queue_.empty() && !busy_ && !needs_full_; });
}

void RenderService::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const auto has_work = [this] { return !queue_.empty(); };
    while (!stop.stop_requested()) {
        if (needs_full_)
            changed_.wait_for(lock, stop, pause_before_full_picture, has_work);
        else
            changed_.wait(lock, stop, has_work);
        if (stop.stop_requested()) return;
        std::vector<Job> jobs = std::exchange(queue_, {});
        if (jobs.empty()) jobs.push_back({[](SceneRenderer&) {}, RenderQuality::full, true});
        busy_ = true;
        lock.unlock();
        const auto done = guarded([&] {
            do_jobs(std::move(jobs));
            return true;
        });
        if (!done) emit failed(to_qt(done.error().message));
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

void RenderService::do_jobs(std::vector<Job> jobs) {
    bool wants_image = false, moving = false;
    for (const Job& job : jobs) {
        job.step(renderer_);
        wants_image = wants_image || job.wants_image;
        moving = moving || (job.wants_image && job.quality == RenderQuality::moving);
    }
    if (wants_image) render(moving ? RenderQuality::moving : RenderQuality::full);
}

void RenderService::render(RenderQuality quality) {
    {
        const std::lock_guard lock(mutex_);
        needs_full_ = quality == RenderQuality::moving;
    }
    if (const auto image = renderer_.render(quality))
        emit rendered(to_qimage(*image), renderer_.camera());
    else
        emit failed(to_qt(image.error().message));
}

}  // namespace covaria::ui
