// Where everything of a chart goes.
#include "ui/charts/chart_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/charts/mark_labels.h"
#include "ui/theme/fonts.h"
#include "ui/theme/label_text.h"

namespace covaria::ui {
namespace {

constexpr double least_part = 0.33;     // of the chart, for the data; else the legend is left out
constexpr double closest_lines = 0.86;  // of a line's height: names of rows that do not touch yet

double widest(const Ticks& ticks, const QFont& font) {
    double width = 0.0;
    for (const Tick& tick : ticks.ticks) width = std::max(width, text_width(tick.text, font));
    return width;
}

/// The first of these that fits: "probability density (1/mm)", "density (1/mm)", "(1/mm)"; of "share of the
/// variance (%)" the words from "of" on are left out first.
Text fitting_title(const Text& title, const QFont& font, double room) {
    if (text_width(title, font) <= room) return title;
    const std::string letters = title.letters();
    const std::size_t unit_at = std::min(letters.rfind(" ("), letters.size());
    const std::size_t of = letters.find(" of "), space = letters.rfind(' ', unit_at - 1);
    const Text unit = title.part(unit_at);
    const Text noun = of > 0 && of < unit_at       ? title.part(0, of)
                      : space == std::string::npos ? title.part(0, unit_at)
                                                   : title.part(space + 1, unit_at);
    if (text_width(noun + unit, font) <= room) return noun + unit;
    const Text bare = title.part(unit_at + 1);
    if (!unit.empty() && text_width(bare, font) <= room) return bare;
    return shortened(noun, font, room);
}

class LayoutBuilder {
public:
    LayoutBuilder(const PlotSpecification& plot, const QSizeF& size, const PlotView& view,
                  const NumberLocale& numbers)
        : plot_(plot), size_(size), numbers_(numbers), map_(has_heat_map(plot)) {
        out_.fonts = fonts_for(size.width());
        out_.geometry.view = view;
        out_.geometry.y_down = !plot.y.categories.empty();
        unit_ = out_.fonts.scale;
        line_ = std::ceil(QFontMetricsF(out_.fonts.label).height());
        edge_ = std::round(8.0 * unit_);
    }

    ChartLayout make() {
        if (plot_.series.empty()) {
            add_message();
            return std::move(out_);
        }
        double top = add_legend(add_title(edge_));
        top_of_body_ = top;
        const double bottom = size_.height() - edge_ - bottom_height();
        // Room for marks depends on the width of the area, which depends on the ticks at its side.
        rows_ = has_labelled_marks() ? 1 : 0;
        set_area(top, bottom);
        const int rows = place_marks();
        if (rows > rows_) {
            rows_ = rows;
            set_area(top, bottom);
            place_marks();
        }
        if (!compact_ && out_.geometry.area.height() < least_part * std::min(size_.width(), size_.height())) {
            LayoutBuilder small(plot_, size_, out_.geometry.view, numbers_);
            small.compact_ = true;
            return small.make();
        }
        // Equal categories both ways: a correlation matrix. Other maps fill their area.
        if (map_ && plot_.x.categories == plot_.y.categories) make_cells_square();
        add_marks();
        add_x_axis();
        add_y_axis();
        if (map_) add_colour_bar();
        return std::move(out_);
    }

private:
    void add_text(const Text& text, QPointF top_left, TextKind kind) {
        const LabelText label(text, font_of(out_.fonts, kind));
        out_.texts.push_back({text, QRectF(top_left, QSizeF(label.width(), label.height())), kind, false});
    }

    void add_message() {
        const QFont& font = out_.fonts.label;
        const std::vector<Text> lines =
            wrapped(plot_.title, font, std::min(0.8 * size_.width(), 34.0 * line_));
        double y = 0.5 * (size_.height() - 1.25 * line_ * static_cast<double>(lines.size()));
        for (const Text& text : lines) {
            add_text(text, {0.5 * (size_.width() - text_width(text, font)), y}, TextKind::message);
            y += 1.25 * line_;
        }
    }

    double add_title(double top) {
        const QFontMetricsF metrics(out_.fonts.title);
        for (const Text& text : wrapped(plot_.title, out_.fonts.title, size_.width() - 2.0 * edge_)) {
            add_text(text, {edge_, top}, TextKind::title);
            top += std::ceil(metrics.height());
        }
        return top + std::round(4.0 * unit_);
    }

    void add_legend_entry(const Text& name, SwatchKind kind, SeriesRole role, QPointF& at) {
        if (name.empty()) return;
        const double swatch = std::round(18.0 * unit_), gap = std::round(5.0 * unit_);
        const double width = swatch + gap + text_width(name, out_.fonts.label);
        if (at.x() > edge_ && at.x() + width > size_.width() - edge_) at = {edge_, at.y() + 1.2 * line_};
        out_.legend.push_back({QRectF(at, QSizeF(swatch, line_)), kind, role});
        add_text(name, at + QPointF(swatch + gap, 0.0), TextKind::label);
        at.rx() += width + std::round(16.0 * unit_);
    }

    double add_legend(double top) {
        if (compact_) return top;
        QPointF at(edge_, top);
        for (const PlotSeries& series : plot_.series) {
            if (series.kind == SeriesKind::heat_map) continue;
            const SwatchKind kind = series.kind == SeriesKind::bars     ? SwatchKind::filling
                                    : series.kind == SeriesKind::points ? SwatchKind::points
                                                                        : SwatchKind::line;
            add_legend_entry(series.name, kind, series.role, at);
        }
        for (const PlotBand& band : plot_.bands)
            add_legend_entry(band.label, SwatchKind::band, band.role, at);
        for (const PlotMark& mark : plot_.marks)
            if (mark.horizontal) add_legend_entry(mark.label, SwatchKind::mark, mark.role, at);
        return out_.legend.empty() ? top : at.y() + 1.2 * line_ + std::round(5.0 * unit_);
    }

    bool has_labelled_marks() const {
        return std::any_of(plot_.marks.begin(), plot_.marks.end(),
                           [](const PlotMark& mark) { return !mark.horizontal && !mark.label.empty(); });
    }

    double tick_length() const { return std::round(4.0 * unit_); }

    double widest_x_category() const {
        double width = 0.0;
        for (const Text& text : plot_.x.categories)
            width = std::max(width, text_width(text, out_.fonts.label));
        return std::min(width, 0.3 * size_.height());
    }

    double bottom_height() const {
        const double title = plot_.x.title.empty() ? 0.0 : line_ + std::round(3.0 * unit_);
        const double labels = turned_ ? widest_x_category() : line_;
        return title + labels + tick_length() + std::round(3.0 * unit_);
    }

    double y_title_width() const { return plot_.y.title.empty() ? 0.0 : line_ + std::round(4.0 * unit_); }

    double y_labels_width() const {
        if (plot_.y.categories.empty()) return widest(out_.y, out_.fonts.figures);
        double width = 0.0;
        for (const Text& text : plot_.y.categories)
            width = std::max(width, text_width(text, out_.fonts.label));
        return std::min(width, 0.4 * size_.width());
    }

    /// Fewer ticks until their texts have room; more of them while there are less than three.
    template <class Make, class Fits>
    static Ticks fitting_ticks(int most, const Make& make, const Fits& fits) {
        Ticks ticks = make(most);
        for (int fewer = most - 1; fewer >= 1 && !fits(ticks); --fewer) ticks = make(fewer);
        for (int more = most + 1; more <= most + 4 && ticks.ticks.size() < 3; ++more)
            if (Ticks richer = make(more); fits(richer)) ticks = std::move(richer);
        return ticks;
    }

    Ticks fitting_x_ticks() const {
        const PlotView& view = out_.geometry.view;
        const double width = out_.geometry.area.width();
        const auto make = [&](int most) {
            return plot_.x.logarithmic ? logarithmic_ticks(view.x_low, view.x_high, most, numbers_)
                                       : linear_ticks(view.x_low, view.x_high, most, numbers_);
        };
        const auto fits = [&](const Ticks& ticks) {
            if (ticks.ticks.size() < 2) return true;
            const double step = ticks.ticks[1].at - ticks.ticks[0].at;
            const double spacing = width * step / (view.x_high - view.x_low);
            return widest(ticks, out_.fonts.figures) + 12.0 * unit_ <= spacing;
        };
        return fitting_ticks(std::max(3, static_cast<int>(width / (72.0 * unit_))), make, fits);
    }

    Ticks fitting_y_ticks(double height) const {
        const PlotView& view = out_.geometry.view;
        const auto make = [&](int most) {
            return plot_.y.logarithmic ? logarithmic_ticks(view.y_low, view.y_high, most, numbers_)
                                       : linear_ticks(view.y_low, view.y_high, most, numbers_);
        };
        const auto fits = [&](const Ticks& ticks) {
            return static_cast<double>(ticks.ticks.size()) * 1.2 * line_ <= height;
        };
        return fitting_ticks(std::max(2, static_cast<int>(height / (46.0 * unit_))), make, fits);
    }

    void set_area(double top, double bottom) {
        const double area_top = top + 1.15 * line_ * rows_ + std::round(2.0 * unit_);
        const double height = std::max(20.0, bottom - area_top);
        if (plot_.y.categories.empty()) out_.y = fitting_y_ticks(height);
        const double left =
            edge_ + y_title_width() + y_labels_width() + tick_length() + std::round(4.0 * unit_);
        double right = size_.width() - std::round(18.0 * unit_);
        if (map_) right -= std::round(44.0 * unit_);
        out_.geometry.area = QRectF(left, area_top, std::max(20.0, right - left), height);
        if (plot_.x.categories.empty()) out_.x = fitting_x_ticks();
    }

    int place_marks() {
        labels_.clear();
        const QRectF& area = out_.geometry.area;
        for (const PlotMark& mark : plot_.marks) {
            const double x = out_.geometry.x_at(on_axis(plot_.x, mark.at));
            if (mark.horizontal || mark.label.empty() || x < area.left() - 0.5 || x > area.right() + 0.5)
                continue;
            labels_.push_back(
                {x, text_width(mark.label, out_.fonts.figures), mark.role == SeriesRole::emphasis, 0.0, 0});
        }
        return place_mark_labels(labels_, edge_, size_.width() - edge_, std::round(12.0 * unit_));
    }

    void add_marks() {
        const QRectF& area = out_.geometry.area;
        const double row = 1.15 * line_;
        std::size_t next = 0;
        for (const PlotMark& mark : plot_.marks) {
            const double x = out_.geometry.x_at(on_axis(plot_.x, mark.at));
            const bool labelled =
                !mark.horizontal && !mark.label.empty() && x >= area.left() - 0.5 && x <= area.right() + 0.5;
            if (!labelled) {
                out_.mark_tops.push_back(area.top());
                continue;
            }
            const MarkLabel& label = labels_[next++];
            const double bottom = area.top() - row * label.row;
            add_text(mark.label, {label.left, bottom - row - std::round(1.0 * unit_)}, TextKind::figures);
            out_.mark_tops.push_back(bottom - std::round(1.0 * unit_));
        }
    }

    void make_cells_square() {
        QRectF& area = out_.geometry.area;
        const double cell = std::min(area.width() / static_cast<double>(plot_.x.categories.size()),
                                     area.height() / static_cast<double>(plot_.y.categories.size()));
        if (!turned_ && widest_x_category() + 6.0 * unit_ > cell) {
            turned_ = true;
            set_area(top_of_body_, size_.height() - edge_ - bottom_height());
            return make_cells_square();
        }
        const QSizeF wanted(cell * static_cast<double>(plot_.x.categories.size()),
                            cell * static_cast<double>(plot_.y.categories.size()));
        area = QRectF(area.left() + std::floor(0.5 * (area.width() - wanted.width())), area.top(),
                      wanted.width(), wanted.height());
    }

    /// Every how many categories are named, so that names have room.
    static std::size_t every(double cell, double text) {
        return static_cast<std::size_t>(std::max(1.0, std::ceil(text / cell)));
    }

    void add_x_categories() {
        const PlotGeometry& geometry = out_.geometry;
        const double top = geometry.area.bottom() + std::round(5.0 * unit_);
        const double cell = geometry.area.width() / (geometry.view.x_high - geometry.view.x_low);
        const std::size_t step = every(cell, turned_ ? closest_lines * line_ : 1.0);
        for (std::size_t i = 0; i < plot_.x.categories.size(); ++i) {
            const double x = geometry.x_at(static_cast<double>(i));
            if (i % step != 0 || x < geometry.area.left() || x > geometry.area.right()) continue;
            const Text text =
                shortened(plot_.x.categories[i], out_.fonts.label, turned_ ? widest_x_category() : 1e9);
            const double width = text_width(text, out_.fonts.label);
            const QRectF box = turned_ ? QRectF(x - 0.5 * line_, top, line_, width)
                                       : QRectF(x - 0.5 * width, top, width, line_);
            out_.texts.push_back({text, box, TextKind::label, turned_});
        }
    }

    void add_x_axis() {
        const PlotGeometry& geometry = out_.geometry;
        const double top = geometry.area.bottom() + tick_length() + std::round(2.0 * unit_);
        if (!plot_.x.categories.empty()) add_x_categories();
        for (const Tick& tick : out_.x.ticks) {
            const double width = text_width(tick.text, out_.fonts.figures);
            const double left = std::min(geometry.x_at(tick.at) - 0.5 * width, size_.width() - width - 1.0);
            add_text(tick.text, {left, top}, TextKind::figures);
        }
        if (plot_.x.title.empty()) return;
        const Text title = title_with_exponent(plot_.x.title, out_.x.exponent);
        const double width = text_width(title, out_.fonts.label);
        const double middle = std::min(geometry.area.center().x(), size_.width() - edge_ - 0.5 * width);
        add_text(title, {std::max(edge_, middle - 0.5 * width), size_.height() - edge_ - line_},
                 TextKind::axis_title);
    }

    void add_y_labels() {
        const PlotGeometry& geometry = out_.geometry;
        const double right = geometry.area.left() - tick_length() - std::round(3.0 * unit_);
        const auto put = [&](double y, const Text& text, TextKind kind) {
            const QFont& font = font_of(out_.fonts, kind);
            add_text(text, {right - text_width(text, font), y - 0.5 * QFontMetricsF(font).height()}, kind);
        };
        for (const Tick& tick : out_.y.ticks) put(geometry.y_at(tick.at), tick.text, TextKind::figures);
        const double cell = geometry.area.height() / (geometry.view.y_high - geometry.view.y_low);
        const std::size_t step = every(cell, closest_lines * line_);
        for (std::size_t i = 0; i < plot_.y.categories.size(); ++i) {
            const double y = geometry.y_at(static_cast<double>(i));
            if (i % step != 0 || y < geometry.area.top() || y > geometry.area.bottom()) continue;
            put(y, shortened(plot_.y.categories[i], out_.fonts.label, y_labels_width()), TextKind::label);
        }
    }

    void add_y_axis() {
        add_y_labels();
        if (plot_.y.title.empty()) return;
        const double room = size_.height() - top_of_body_ - edge_;
        const Text title =
            fitting_title(title_with_exponent(plot_.y.title, out_.y.exponent), out_.fonts.label, room);
        const double length = text_width(title, out_.fonts.label);
        const double top = std::clamp(out_.geometry.area.center().y() - 0.5 * length, top_of_body_,
                                      std::max(top_of_body_, size_.height() - edge_ - length));
        out_.texts.push_back({title, QRectF(edge_, top, line_, length), TextKind::axis_title, true});
    }

    void add_colour_bar() {
        const QRectF& area = out_.geometry.area;
        out_.colour_bar = QRectF(area.right() + std::round(16.0 * unit_), area.top(),
                                 std::round(10.0 * unit_), area.height());
        const int most = std::max(2, std::min(4, static_cast<int>(area.height() / (30.0 * unit_))));
        for (const Tick& tick : linear_ticks(plot_.z_low, plot_.z_high, most, numbers_).ticks) {
            const double part = (tick.at - plot_.z_low) / (plot_.z_high - plot_.z_low);
            const double y = std::clamp(area.bottom() - part * area.height(), area.top() + 0.4 * line_,
                                        area.bottom() - 0.4 * line_);
            add_text(tick.text, {out_.colour_bar.right() + std::round(5.0 * unit_), y - 0.5 * line_},
                     TextKind::figures);
        }
    }

    const PlotSpecification& plot_;
    QSizeF size_;
    NumberLocale numbers_;
    bool map_;
    bool compact_ = false;  // no room for a legend
    bool turned_ = false;   // names of the x categories
    double unit_ = 1.0, line_ = 0.0, edge_ = 0.0, top_of_body_ = 0.0;
    int rows_ = 0;  // of mark labels
    std::vector<MarkLabel> labels_;
    ChartLayout out_;
};

}  // namespace

ChartFonts fonts_for(double width) {
    const int size = width < 340.0 ? 10 : width < 560.0 ? 11 : 12;
    QFont font(text_family());
    font.setPixelSize(size);
    font.setHintingPreference(QFont::PreferNoHinting);
    // As in the report: alternates of parentheses and signs would be lost when text is copied out of a PDF.
    font.setStyleStrategy(QFont::PreferNoShaping);
    ChartFonts fonts{font, font, with_tabular_figures(font), size / 12.0};
    fonts.title.setPixelSize(size + 1);
    fonts.title.setWeight(QFont::DemiBold);
    return fonts;
}

const QFont& font_of(const ChartFonts& fonts, TextKind kind) {
    switch (kind) {
        case TextKind::title:
            return fonts.title;
        case TextKind::figures:
            return fonts.figures;
        case TextKind::label:
        case TextKind::axis_title:
        case TextKind::message:
            return fonts.label;
    }
    return fonts.label;
}

ChartLayout layout_chart(const PlotSpecification& plot, const QSizeF& size, const PlotView& view,
                         const NumberLocale& numbers) {
    return LayoutBuilder(plot, size, view, numbers).make();
}

}  // namespace covaria::ui
