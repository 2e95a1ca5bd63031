// The place of every part of a chart.
#include "ui/charts/chart_layout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "core/text/head_with_unit.h"
#include "ui/charts/mark_labels.h"
#include "ui/theme/fonts.h"
#include "ui/theme/label_text.h"

namespace covaria::ui {
namespace {

constexpr double least_part = 0.33;     // part of the chart that its data need; else the legend is left out
constexpr double closest_lines = 0.86;  // part of a line's height at which names of rows do not touch yet

double widest(const Ticks& ticks, const QFont& font) {
    double width = 0.0;
    for (const Tick& tick : ticks.ticks) width = std::max(width, text_width(tick.text, font));
    return width;
}

/// The title, else its short form, else the words shortened before the unit ("Wahrsch…dichte / (1/mm)").
Text fitting_title(const PlotAxis& axis, int exponent, const QFont& font, double room) {
    const auto titled = [&](const Text& words) { return head_with_unit(words, axis.unit, exponent); };
    const Text& shorter = axis.short_title.empty() ? axis.title : axis.short_title;
    for (const Text& words : {axis.title, shorter})
        if (const Text title = titled(words); text_width(title, font) <= room) return title;
    const Text unit = titled({});  // "(1/mm)"
    if (unit.empty()) return shortened(shorter, font, room);
    const double left = room - (text_width(titled(shorter), font) - text_width(shorter, font));
    if (left >= text_width("nnn…", font)) return titled(shortened(shorter, font, left));
    return text_width(unit, font) <= room ? unit : shortened(titled(shorter), font, room);
}

/// The chart while it is laid out: what is there already, and the measures that everything is set by.
struct Sheet {
    Sheet(const PlotSpecification& of, const QSizeF& in, const PlotView& view, const NumberLocale& locale)
        : plot(of), size(in), numbers(locale) {
        out.fonts = fonts_for(in.width());
        out.geometry.view = view;
        out.geometry.y_down = !of.y.categories.empty();
        unit = out.fonts.scale;
        line = std::ceil(QFontMetricsF(out.fonts.label).height());
        edge = std::round(8.0 * unit);
    }

    void add_text(const Text& text, QPointF top_left, TextKind kind) {
        const LabelText label(text, font_of(out.fonts, kind));
        out.texts.push_back({text, QRectF(top_left, QSizeF(label.width(), label.height())), kind, false});
    }

    double tick_length() const { return std::round(4.0 * unit); }

    double widest_x_category() const {
        double width = 0.0;
        for (const Text& text : plot.x.categories) width = std::max(width, text_width(text, out.fonts.label));
        return std::min(width, 0.3 * size.height());
    }

    double y_labels_width() const {
        if (plot.y.categories.empty()) return widest(out.y, out.fonts.figures);
        double width = 0.0;
        for (const Text& text : plot.y.categories) width = std::max(width, text_width(text, out.fonts.label));
        return std::min(width, 0.4 * size.width());
    }

    const PlotSpecification& plot;
    QSizeF size;
    NumberLocale numbers;
    bool turned = false;  ///< names of the x categories
    double unit = 1.0, line = 0.0, edge = 0.0, top_of_body = 0.0;
    ChartLayout out;
};

/// Fewer ticks until their texts have room; more of them while there are less than three.
template <class Make, class Fits>
Ticks fitting_ticks(int most, const Make& make, const Fits& fits) {
    Ticks ticks = make(most);
    for (int fewer = most - 1; fewer >= 1 && !fits(ticks); --fewer) ticks = make(fewer);
    for (int more = most + 1; more <= most + 4 && ticks.ticks.size() < 3; ++more)
        if (Ticks richer = make(more); fits(richer)) ticks = std::move(richer);
    return ticks;
}

Ticks fitting_x_ticks(const Sheet& sheet) {
    const PlotView& view = sheet.out.geometry.view;
    const double width = sheet.out.geometry.area.width();
    const auto make = [&](int most) {
        return sheet.plot.x.logarithmic
                   ? logarithmic_ticks(view.x_low, view.x_high, most, sheet.numbers)
                   : linear_ticks(view.x_low, view.x_high, most, sheet.numbers, sheet.plot.x.exponent);
    };
    const auto fits = [&](const Ticks& ticks) {
        if (ticks.ticks.size() < 2) return true;
        const double step = ticks.ticks[1].at - ticks.ticks[0].at;
        const double spacing = width * step / (view.x_high - view.x_low);
        return widest(ticks, sheet.out.fonts.figures) + 12.0 * sheet.unit <= spacing;
    };
    return fitting_ticks(std::max(3, static_cast<int>(width / (72.0 * sheet.unit))), make, fits);
}

Ticks fitting_y_ticks(const Sheet& sheet, double height) {
    const PlotView& view = sheet.out.geometry.view;
    const auto make = [&](int most) {
        return sheet.plot.y.logarithmic
                   ? logarithmic_ticks(view.y_low, view.y_high, most, sheet.numbers)
                   : linear_ticks(view.y_low, view.y_high, most, sheet.numbers, sheet.plot.y.exponent);
    };
    const auto fits = [&](const Ticks& ticks) {
        return static_cast<double>(ticks.ticks.size()) * 1.2 * sheet.line <= height;
    };
    return fitting_ticks(std::max(2, static_cast<int>(height / (46.0 * sheet.unit))), make, fits);
}

/// The texts along the axes.
class AxisTexts {
public:
    explicit AxisTexts(Sheet& sheet) : sheet_(sheet) {}

    void add_x() {
        const PlotGeometry& geometry = sheet_.out.geometry;
        const double top = geometry.area.bottom() + sheet_.tick_length() + std::round(2.0 * sheet_.unit);
        if (!sheet_.plot.x.categories.empty()) add_x_categories();
        for (const Tick& tick : sheet_.out.x.ticks) {
            const double width = text_width(tick.text, sheet_.out.fonts.figures);
            const double left =
                std::min(geometry.x_at(tick.at) - 0.5 * width, sheet_.size.width() - width - 1.0);
            sheet_.add_text(tick.text, {left, top}, TextKind::figures);
        }
        if (sheet_.plot.x.title.empty()) return;
        const Text title = head_with_unit(sheet_.plot.x.title, sheet_.plot.x.unit, sheet_.out.x.exponent);
        const double width = text_width(title, sheet_.out.fonts.label);
        const double middle =
            std::min(geometry.area.center().x(), sheet_.size.width() - sheet_.edge - 0.5 * width);
        sheet_.add_text(
            title,
            {std::max(sheet_.edge, middle - 0.5 * width), sheet_.size.height() - sheet_.edge - sheet_.line},
            TextKind::axis_title);
    }

    void add_y() {
        add_y_labels();
        if (sheet_.plot.y.title.empty()) return;
        const double room = sheet_.size.height() - sheet_.top_of_body - sheet_.edge;
        const Text title = fitting_title(sheet_.plot.y, sheet_.out.y.exponent, sheet_.out.fonts.label, room);
        const double length = text_width(title, sheet_.out.fonts.label);
        const double top =
            std::clamp(sheet_.out.geometry.area.center().y() - 0.5 * length, sheet_.top_of_body,
                       std::max(sheet_.top_of_body, sheet_.size.height() - sheet_.edge - length));
        sheet_.out.texts.push_back(
            {title, QRectF(sheet_.edge, top, sheet_.line, length), TextKind::axis_title, true});
    }

    void add_colour_bar() {
        const QRectF& area = sheet_.out.geometry.area;
        sheet_.out.colour_bar = QRectF(area.right() + std::round(16.0 * sheet_.unit), area.top(),
                                       std::round(10.0 * sheet_.unit), area.height());
        const int most = std::max(2, std::min(4, static_cast<int>(area.height() / (30.0 * sheet_.unit))));
        for (const Tick& tick :
             linear_ticks(sheet_.plot.z_low, sheet_.plot.z_high, most, sheet_.numbers).ticks) {
            const double part = (tick.at - sheet_.plot.z_low) / (sheet_.plot.z_high - sheet_.plot.z_low);
            const double y = std::clamp(area.bottom() - part * area.height(), area.top() + 0.4 * sheet_.line,
                                        area.bottom() - 0.4 * sheet_.line);
            sheet_.add_text(
                tick.text,
                {sheet_.out.colour_bar.right() + std::round(5.0 * sheet_.unit), y - 0.5 * sheet_.line},
                TextKind::figures);
        }
    }

private:
    /// Every how many categories are named, so that names have room.
    static std::size_t every(double cell, double text) {
        return static_cast<std::size_t>(std::max(1.0, std::ceil(text / cell)));
    }

    void add_x_categories() {
        const PlotGeometry& geometry = sheet_.out.geometry;
        const double top = geometry.area.bottom() + std::round(5.0 * sheet_.unit);
        const double cell = geometry.area.width() / (geometry.view.x_high - geometry.view.x_low);
        const std::size_t step = every(cell, sheet_.turned ? closest_lines * sheet_.line
                                                           : sheet_.widest_x_category() + 6.0 * sheet_.unit);
        for (std::size_t i = 0; i < sheet_.plot.x.categories.size(); ++i) {
            const double x = geometry.x_at(static_cast<double>(i));
            if (i % step != 0 || x < geometry.area.left() || x > geometry.area.right()) continue;
            const Text text = shortened(sheet_.plot.x.categories[i], sheet_.out.fonts.label,
                                        sheet_.turned ? sheet_.widest_x_category() : 1e9);
            const double width = text_width(text, sheet_.out.fonts.label);
            const QRectF box = sheet_.turned ? QRectF(x - 0.5 * sheet_.line, top, sheet_.line, width)
                                             : QRectF(x - 0.5 * width, top, width, sheet_.line);
            sheet_.out.texts.push_back({text, box, TextKind::label, sheet_.turned});
        }
    }

    void add_y_labels() {
        const PlotGeometry& geometry = sheet_.out.geometry;
        const double right = geometry.area.left() - sheet_.tick_length() - std::round(3.0 * sheet_.unit);
        const auto put = [&](double y, const Text& text, TextKind kind) {
            const QFont& font = font_of(sheet_.out.fonts, kind);
            sheet_.add_text(text, {right - text_width(text, font), y - 0.5 * QFontMetricsF(font).height()},
                            kind);
        };
        for (const Tick& tick : sheet_.out.y.ticks) put(geometry.y_at(tick.at), tick.text, TextKind::figures);
        const double cell = geometry.area.height() / (geometry.view.y_high - geometry.view.y_low);
        const std::size_t step = every(cell, closest_lines * sheet_.line);
        const std::vector<Text> names =
            shortened_apart(sheet_.plot.y.categories, sheet_.out.fonts.label, sheet_.y_labels_width());
        for (std::size_t i = 0; i < names.size(); ++i) {
            const double y = geometry.y_at(static_cast<double>(i));
            if (i % step != 0 || y < geometry.area.top() || y > geometry.area.bottom()) continue;
            put(y, names[i], TextKind::label);
        }
    }

    Sheet& sheet_;
};

class LayoutBuilder {
public:
    LayoutBuilder(const PlotSpecification& plot, const QSizeF& size, const PlotView& view,
                  const NumberLocale& numbers)
        : sheet_(plot, size, view, numbers), map_(has_heat_map(plot)) {}

    ChartLayout make() {
        if (sheet_.plot.series.empty()) {
            add_message();
            return std::move(sheet_.out);
        }
        double top = add_legend(add_title(sheet_.edge));
        sheet_.top_of_body = top;
        const double bottom = sheet_.size.height() - sheet_.edge - bottom_height();
        // Room for marks depends on the width of the area, which depends on the ticks at its side.
        rows_ = has_labelled_marks() ? 1 : 0;
        set_area(top, bottom);
        const int rows = place_marks();
        if (rows > rows_) {
            rows_ = rows;
            set_area(top, bottom);
            place_marks();
        }
        if (!compact_ && sheet_.out.geometry.area.height() <
                             least_part * std::min(sheet_.size.width(), sheet_.size.height())) {
            LayoutBuilder small(sheet_.plot, sheet_.size, sheet_.out.geometry.view, sheet_.numbers);
            small.compact_ = true;
            return small.make();
        }
        // Equal categories both ways: a correlation matrix. Other maps fill their area.
        if (map_ && sheet_.plot.x.categories == sheet_.plot.y.categories) make_cells_square();
        add_marks();
        AxisTexts axes(sheet_);
        axes.add_x();
        axes.add_y();
        if (map_) axes.add_colour_bar();
        return std::move(sheet_.out);
    }

private:
    void add_message() {
        const QFont& font = sheet_.out.fonts.label;
        const std::vector<Text> lines =
            wrapped(sheet_.plot.title, font, std::min(0.8 * sheet_.size.width(), 34.0 * sheet_.line));
        double y = 0.5 * (sheet_.size.height() - 1.25 * sheet_.line * static_cast<double>(lines.size()));
        for (const Text& text : lines) {
            sheet_.add_text(text, {0.5 * (sheet_.size.width() - text_width(text, font)), y},
                            TextKind::message);
            y += 1.25 * sheet_.line;
        }
    }

    double add_title(double top) {
        const QFontMetricsF metrics(sheet_.out.fonts.title);
        for (const Text& text :
             wrapped(sheet_.plot.title, sheet_.out.fonts.title, sheet_.size.width() - 2.0 * sheet_.edge)) {
            sheet_.add_text(text, {sheet_.edge, top}, TextKind::title);
            top += std::ceil(metrics.height());
        }
        return top + std::round(4.0 * sheet_.unit);
    }

    void add_legend_entry(const Text& name, SwatchKind kind, SeriesRole role, QPointF& at) {
        if (name.empty()) return;
        const double swatch = std::round(18.0 * sheet_.unit), gap = std::round(5.0 * sheet_.unit);
        const double width = swatch + gap + text_width(name, sheet_.out.fonts.label);
        if (at.x() > sheet_.edge && at.x() + width > sheet_.size.width() - sheet_.edge)
            at = {sheet_.edge, at.y() + 1.2 * sheet_.line};
        sheet_.out.legend.push_back({QRectF(at, QSizeF(swatch, sheet_.line)), kind, role});
        const double room = sheet_.size.width() - sheet_.edge - at.x() - swatch - gap;
        const std::vector<Text> lines = wrapped(name, sheet_.out.fonts.label, room);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (i > 0) at.ry() += sheet_.line;
            sheet_.add_text(lines[i], at + QPointF(swatch + gap, 0.0), TextKind::label);
        }
        at.rx() += width + std::round(16.0 * sheet_.unit);
    }

    double add_legend(double top) {
        if (compact_) return top;
        QPointF at(sheet_.edge, top);
        for (const PlotSeries& series : sheet_.plot.series) {
            if (series.kind == SeriesKind::heat_map) continue;
            const SwatchKind kind = series.kind == SeriesKind::bars     ? SwatchKind::filling
                                    : series.kind == SeriesKind::points ? SwatchKind::points
                                                                        : SwatchKind::line;
            add_legend_entry(series.name, kind, series.role, at);
        }
        for (const PlotBand& band : sheet_.plot.bands)
            add_legend_entry(band.label, SwatchKind::band, band.role, at);
        for (const PlotMark& mark : sheet_.plot.marks)
            if (mark.horizontal) add_legend_entry(mark.label, SwatchKind::mark, mark.role, at);
        return sheet_.out.legend.empty() ? top : at.y() + 1.2 * sheet_.line + std::round(5.0 * sheet_.unit);
    }

    bool has_labelled_marks() const {
        return std::any_of(sheet_.plot.marks.begin(), sheet_.plot.marks.end(),
                           [](const PlotMark& mark) { return !mark.horizontal && !mark.label.empty(); });
    }

    double bottom_height() const {
        const double title = sheet_.plot.x.title.empty() ? 0.0 : sheet_.line + std::round(3.0 * sheet_.unit);
        const double labels = sheet_.turned ? sheet_.widest_x_category() : sheet_.line;
        return title + labels + sheet_.tick_length() + std::round(3.0 * sheet_.unit);
    }

    double y_title_width() const {
        return sheet_.plot.y.title.empty() ? 0.0 : sheet_.line + std::round(4.0 * sheet_.unit);
    }

    void set_area(double top, double bottom) {
        const double area_top = top + 1.15 * sheet_.line * rows_ + std::round(2.0 * sheet_.unit);
        const double height = std::max(20.0, bottom - area_top);
        if (sheet_.plot.y.categories.empty()) sheet_.out.y = fitting_y_ticks(sheet_, height);
        const double left = sheet_.edge + y_title_width() + sheet_.y_labels_width() + sheet_.tick_length() +
                            std::round(4.0 * sheet_.unit);
        double right = sheet_.size.width() - std::round(18.0 * sheet_.unit);
        if (map_) right -= std::round(44.0 * sheet_.unit);
        sheet_.out.geometry.area = QRectF(left, area_top, std::max(20.0, right - left), height);
        if (sheet_.plot.x.categories.empty()) sheet_.out.x = fitting_x_ticks(sheet_);
    }

    int place_marks() {
        labels_.clear();
        const QRectF& area = sheet_.out.geometry.area;
        for (const PlotMark& mark : sheet_.plot.marks) {
            const double x = sheet_.out.geometry.x_at(on_axis(sheet_.plot.x, mark.at));
            if (mark.horizontal || mark.label.empty() || x < area.left() - 0.5 || x > area.right() + 0.5)
                continue;
            labels_.push_back({x, text_width(mark.label, sheet_.out.fonts.figures),
                               mark.role == SeriesRole::emphasis, 0.0, 0});
        }
        return place_mark_labels(labels_, sheet_.edge, sheet_.size.width() - sheet_.edge,
                                 std::round(12.0 * sheet_.unit));
    }

    void add_marks() {
        const QRectF& area = sheet_.out.geometry.area;
        const double row = 1.15 * sheet_.line;
        std::size_t next = 0;
        for (const PlotMark& mark : sheet_.plot.marks) {
            const double x = sheet_.out.geometry.x_at(on_axis(sheet_.plot.x, mark.at));
            const bool labelled =
                !mark.horizontal && !mark.label.empty() && x >= area.left() - 0.5 && x <= area.right() + 0.5;
            if (!labelled) {
                sheet_.out.mark_tops.push_back(area.top());
                continue;
            }
            const MarkLabel& label = labels_[next++];
            const double bottom = area.top() - row * label.row;
            sheet_.add_text(mark.label, {label.left, bottom - row - std::round(1.0 * sheet_.unit)},
                            TextKind::figures);
            sheet_.out.mark_tops.push_back(bottom - std::round(1.0 * sheet_.unit));
        }
    }

    void make_cells_square() {
        QRectF& area = sheet_.out.geometry.area;
        const double cell = std::min(area.width() / static_cast<double>(sheet_.plot.x.categories.size()),
                                     area.height() / static_cast<double>(sheet_.plot.y.categories.size()));
        if (!sheet_.turned && sheet_.widest_x_category() + 6.0 * sheet_.unit > cell) {
            sheet_.turned = true;
            set_area(sheet_.top_of_body, sheet_.size.height() - sheet_.edge - bottom_height());
            return make_cells_square();
        }
        const QSizeF wanted(cell * static_cast<double>(sheet_.plot.x.categories.size()),
                            cell * static_cast<double>(sheet_.plot.y.categories.size()));
        area = QRectF(area.left() + std::floor(0.5 * (area.width() - wanted.width())), area.top(),
                      wanted.width(), wanted.height());
    }

    Sheet sheet_;
    bool map_;
    bool compact_ = false;  // no room for a legend
    int rows_ = 0;          // rows of mark labels
    std::vector<MarkLabel> labels_;
};

}  // namespace

ChartFonts fonts_for(double width) {
    const int size = width < 340.0 ? 10 : width < 560.0 ? 11 : 12;
    QFont font(text_families());
    font.setPixelSize(size);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Reports have it, too: alternates of parentheses and signs would be lost in text copied out of a PDF.
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
