// Bookmarks of a finished PDF: Qt 6.4 writes none.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria::ui {

struct Bookmark {
    std::string title;  ///< UTF-8
    int level = 1;      ///< those of a higher level are within the last of a lower one
    int page = 0;       ///< from 0
    double y = 0.0;     ///< from the bottom of the page, in points
};

/// The same pages with bookmarks, as an incremental update (ISO 32000-1 7.5.6, 12.3.3). Error{numeric}: it is
/// no PDF with a table of objects and a list of pages as QPdfWriter writes them.
Result<std::string> with_bookmarks(std::string pdf, const std::vector<Bookmark>& bookmarks);

}  // namespace covaria::ui
