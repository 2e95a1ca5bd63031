// The pages of a report under each other, at any size.
#pragma once

#include <QAbstractScrollArea>
#include <QImage>
#include <map>
#include <vector>

#include "ui/print/report_pages.h"

namespace covaria::ui {

/// Size of the pages shown: fitted to the room there is, or by a factor (1: an inch of paper is an inch of
/// the screen).
struct PageZoom {
    enum class Fit { width, page, none };
    Fit fit = Fit::width;
    double factor = 1.0;  ///< applies where nothing is fitted

    bool operator==(const PageZoom&) const = default;
};

/// Pages are drawn as they come into view, as sharp as the screen is.
class PageView : public QAbstractScrollArea {
    Q_OBJECT
public:
    explicit PageView(QWidget* parent = nullptr);

    void set_pages(std::vector<PrintedPage> pages);
    int page_count() const { return int(pages_.size()); }
    /// Index of the page of which most is visible; -1 without pages.
    int current_page() const { return current_; }
    void go_to_page(int page);
    /// Changes the zoom; the place in the middle of the view stays there.
    void set_zoom(PageZoom zoom);
    PageZoom zoom() const { return zoom_; }
    /// The factor at which pages are shown, fitted or not.
    double scale() const;
    /// Zooms to the next of the offered factors, up (1) or down (-1).
    void step_zoom(int direction);
    /// Place of a page in the viewport.
    QRect page_rect(int page) const;

    static const std::vector<double>& offered_factors();

signals:
    void current_page_changed(int page);
    void zoom_changed();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;

private:
    QSizeF page_size(int page) const;
    int top_of(int page) const;
    void lay_out();
    void take_current_page();
    const QImage& sharp(int page);

    std::vector<PrintedPage> pages_;
    PageZoom zoom_;
    std::map<int, QImage> shown_;  ///< pictures of the pages in view, drawn at shown_scale_
    double shown_scale_ = 0.0;
    int current_ = -1;
    double above_ = 0.0;  ///< part of the current page that is above the view
    int wheel_ = 0;       ///< turned since the last step, in eighths of a degree
};

}  // namespace covaria::ui
