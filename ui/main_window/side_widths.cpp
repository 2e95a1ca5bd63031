#include "ui/main_window/side_widths.h"

#include <QWidget>
#include <algorithm>

namespace covaria::ui {

QList<int> side_widths(const QWidget& window) {
    constexpr int tree = 184, inspector = 320, inspector_of_small = 296, small_window = 1360, usual_line = 16;
    constexpr int wide_window = 1440;  // from there on names get more room
    const double scale = std::max(1.0, window.fontMetrics().height() / double(usual_line));
    const int more = std::clamp((window.width() - wide_window) / 6, 0, 96);
    const int forms = window.width() < small_window ? inspector_of_small : inspector + more;
    return {std::min(int(scale * (tree + more)), window.width() / 5),
            std::min(int(scale * forms), (29 * window.width()) / 100)};
}

}  // namespace covaria::ui
