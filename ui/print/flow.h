// Content flows over pages: items with heights, kept together where they must be, table heads repeated.
#pragma once

#include <QPainter>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace covaria::ui {

/// Paints an item with its top left corner at the given point.
using PaintAt = std::function<void(QPainter&, QPointF)>;

/// The head of a table, put again at the top of each page on which the table goes on.
struct RepeatedHead {
    double height = 0.0;
    PaintAt paint;
};

struct FlowItem {
    double height = 0.0;
    double space_before = 0.0;  ///< dropped at the top of a page
    bool keep_with_next = false;
    PaintAt paint;
    std::shared_ptr<const RepeatedHead> head = {};  ///< head of the table that the item is a row of
    std::string heading = {};                       ///< heading that a reader may go to
    int heading_level = 0;
    bool begins_page = false;
    std::optional<std::size_t> leads_to = {};  ///< number of the heading, of all in their order
};

struct PlacedItem {
    int page = 0;
    double y = 0.0;  ///< from the top of the text area
    PaintAt paint;
};

struct PlacedHeading {
    std::string text;
    int level = 1;
    int page = 0;
    double y = 0.0;  ///< from the top of the text area
};

/// A line that leads to a heading.
struct PlacedLink {
    int page = 0;
    double y = 0.0, height = 0.0;  ///< from the top of the text area
    std::size_t heading = 0;
};

struct FlowedPages {
    std::vector<PlacedItem> items;  ///< in order of pages
    std::vector<PlacedHeading> headings = {};
    std::vector<PlacedLink> links = {};
    int pages = 1;
};

/// Breaks the items into pages of the given height. A run of items that keep together moves to the next page
/// as a whole if it fits there; an item taller than a page is placed at its top.
FlowedPages flow(const std::vector<FlowItem>& items, double page_height);

}  // namespace covaria::ui
