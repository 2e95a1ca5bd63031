// Reduces a screenshot and compares it.
#include "tests/ui/main_window/baseline_check.h"

#include <cstring>

#include "tests/viz/vtk/picture_check.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

testing::AssertionResult matches_screenshot(const QImage& image, const QString& folder, const QString& name) {
    const QImage quarter = image.scaled(image.size() / 4, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                               .convertToFormat(QImage::Format_RGBA8888);
    Image reduced{quarter.width(), quarter.height(), {}};
    const std::size_t row = 4 * std::size_t(quarter.width());
    reduced.rgba.resize(row * std::size_t(quarter.height()));
    for (int y = 0; y < quarter.height(); ++y)
        std::memcpy(&reduced.rgba[row * std::size_t(y)], quarter.constScanLine(y), row);
    const test::Difference largest{0.02, 1.5};
    return test::matches_baseline(reduced, to_path(folder + QLatin1Char('/') + name + QStringLiteral(".png")),
                                  largest);
}

}  // namespace covaria::ui
