// Content flows over pages: items with heights, kept together where they must be, table heads repeated.
#include "ui/print/flow.h"

namespace covaria::ui {
namespace {

/// Height of the run that starts at `first` and must stay on one page.
double run_height(const std::vector<FlowItem>& items, std::size_t first) {
    double height = 0.0;
    for (std::size_t i = first; i < items.size(); ++i) {
        height += items[i].height + (i > first ? items[i].space_before : 0.0);
        if (!items[i].keep_with_next) break;
    }
    return height;
}

class Flower {
public:
    explicit Flower(double page_height) : page_height_(page_height) {}

    void place(const std::vector<FlowItem>& items, std::size_t i) {
        const FlowItem& item = items[i];
        const bool starts_run = i == 0 || !items[i - 1].keep_with_next;
        const double needed = starts_run ? run_height(items, i) : item.height;
        const bool whole_run_fits_a_page = needed <= page_height_;
        const double least = whole_run_fits_a_page ? needed : item.height;
        if (!at_top() && (item.begins_page || y_ + item.space_before + least > page_height_))
            break_page(item);
        if (!at_top()) y_ += item.space_before;
        if (!item.heading.empty()) pages_.headings.push_back({item.heading, item.heading_level, page_, y_});
        if (item.leads_to) pages_.links.push_back({page_, y_, item.height, *item.leads_to});
        put(item.height, item.paint);
    }

    FlowedPages take() {
        pages_.pages = page_ + 1;
        return std::move(pages_);
    }

private:
    bool at_top() const { return top_; }

    void break_page(const FlowItem& next) {
        ++page_;
        y_ = 0.0;
        top_ = true;
        if (next.head) put(next.head->height, next.head->paint);
    }

    void put(double height, const PaintAt& paint) {
        pages_.items.push_back({page_, y_, paint});
        y_ += height;
        top_ = false;
    }

    double page_height_;
    double y_ = 0.0;
    int page_ = 0;
    bool top_ = true;
    FlowedPages pages_;
};

}  // namespace

FlowedPages flow(const std::vector<FlowItem>& items, double page_height) {
    Flower flower(page_height);
    for (std::size_t i = 0; i < items.size(); ++i) flower.place(items, i);
    return flower.take();
}

}  // namespace covaria::ui
