// Painting of a SceneView: the picture, and the marks over it.
#include <QPainter>
#include <algorithm>

#include "ui/run/result_words.h"
#include "ui/scene_view/handle_painter.h"
#include "ui/scene_view/scene_view.h"
#include "ui/scene_view/view_cube_painter.h"
#include "ui/scene_view/visibility_note.h"
#include "ui/theme/strings.h"
#include "viz/scene/section.h"

namespace covaria::ui {
namespace {

constexpr double radius_of_ring = 6.0;  // about the dots of a trial that was picked

void draw_image(QPainter& painter, const QWidget& view, const QImage& image) {
    painter.setOpacity(view.property(is_faint).toBool() ? opacity_of_last : 1.0);
    painter.drawImage(view.rect(), image);
    painter.setOpacity(1.0);
}

}  // namespace

void SceneView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (scene_ && !image_.isNull() && failure_.isEmpty()) {
        paint_picture(painter);
    } else {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        const QString text = failure_.isEmpty() ? (scene_ ? tr("Drawing …") : empty_text_) : failure_;
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, text);
    }
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void SceneView::paint_picture(QPainter& painter) const {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    draw_image(painter, *this, image_);
    if (const QString item = item_with_handles(); !item.isEmpty())
        paint_handles(painter,
                      handle_marks(*scene_, camera_, picture_size(), to_std(item),
                                   length_of_arrow * devicePixelRatioF()),
                      moved_ ? moved_->axis : grasped_axis_, palette_, devicePixelRatioF());
    if (picked_trial_ && layers_[Layer::clouds]) paint_trial(painter, *picked_trial_);
    paint_cube(painter, cube(), pointed_, palette());
    if (const QString hidden = visibility_words(*whole_, visibility_); !hidden.isEmpty())
        paint_note(painter, *this, hidden);
}

void SceneView::paint_trial(QPainter& painter, std::uint64_t trial) const {
    painter.setRenderHint(QPainter::Antialiasing);
    const double ratio = devicePixelRatioF();
    for (const SceneCloud& cloud : scene_->clouds) {
        const auto found = std::find(cloud.trials.begin(), cloud.trials.end(), trial);
        if (found == cloud.trials.end()) continue;
        const auto dot = static_cast<std::size_t>(found - cloud.trials.begin());
        if (is_cut_away(*scene_, cloud.dot(dot))) continue;
        const Pixel at = project(camera_, picture_size(), cloud.dot(dot));
        const QPointF middle(at.x / ratio, at.y / ratio);
        for (const auto& [role, width] : {std::pair(QPalette::Base, 4.0), std::pair(QPalette::Text, 1.6)}) {
            painter.setPen(QPen(palette().color(role), width));
            painter.drawEllipse(middle, radius_of_ring, radius_of_ring);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace covaria::ui
