// Shared by the tests of charts: a QApplication without display, charts to draw, and what to do with a wrong
// picture.
#pragma once

#include <gtest/gtest.h>

#include <QColor>
#include <QDir>
#include <QImage>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/views/plots.h"
#include "tests/core/views/plot_sample.h"
#include "ui/charts/chart_painter.h"

namespace covaria::ui::test {

/// Every chart, in light and dark themes alike.
inline std::vector<PlotSpecification> all_plots() {
    const UncertaintyResult result = covaria::test::plot_sample();
    UncertaintyResult first_order_only = result;
    for (OutputResult& output : first_order_only.outputs) output.monte_carlo.reset();
    return {histogram_plot(result, 0),
            histogram_plot(result, 5),
            normal_quantile_plot(result, 2),
            contribution_plot(result, 0),
            correlation_plot(result, outputs_to_correlate(result, "pose 7")),
            correlation_plot(result, outputs_to_correlate(result, "")),
            convergence_plot(result, 3),
            histogram_plot(first_order_only, 0)};
}

inline int difference(const QColor& a, const QColor& b) {
    return std::max(
        {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

/// Smallest difference to `colour` among the pixels around `place`.
inline int nearest_difference(const QImage& image, QPointF place, const QColor& colour, int reach = 2) {
    int least = 255;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const QPoint pixel(int(std::floor(place.x())) + x, int(std::floor(place.y())) + y);
            if (image.valid(pixel)) least = std::min(least, difference(image.pixelColor(pixel), colour));
        }
    return least;
}

/// Keeps the picture of a failed test and says where it is.
class PictureTest : public ::testing::Test {
protected:
    const QImage& draw(const ShownPlot& shown, double pixel_ratio = 1.0) {
        image_ = plot_image(shown, pixel_ratio);
        return image_;
    }
    void TearDown() override {
        if (!HasFailure() || image_.isNull()) return;
        const QString folder = QStringLiteral(COVARIA_BINARY_DIR "/failed-pictures");
        QDir().mkpath(folder);
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        const QString file =
            QStringLiteral("%1/%2-%3.png").arg(folder, info->test_suite_name(), info->name());
        image_.save(file);
        ADD_FAILURE() << "the picture is at " << file.toStdString();
    }
    QImage image_;
};

}  // namespace covaria::ui::test
