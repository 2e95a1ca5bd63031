// Paper, margins, fonts and greys of the printed report; lengths in device units of the painter.
#pragma once

#include <QColor>
#include <QFont>
#include <QPageSize>
#include <QPaintDevice>
#include <QRectF>

namespace covaria::ui {

enum class PaperSize { a4, letter };

enum class TextRole {
    title,
    heading_1,
    heading_2,
    heading_3,
    body,
    note,
    table,
    table_head,
    caption,
    running
};

/// Sizes and fonts for one paint device. Numbers in tables are set in a family whose figures are all equally
/// wide.
class PageStyle {
public:
    PageStyle(QPaintDevice* device, PaperSize paper);

    double mm(double length) const;
    double points(double length) const;
    QRectF text_area() const { return text_area_; }  ///< area of the flowing content
    QRectF sheet() const { return sheet_; }
    QFont font(TextRole role) const;
    QFont figures_font() const;                ///< numbers in tables
    PageStyle with_fonts(double scale) const;  ///< the same page, with fonts of that part of their size
    QPaintDevice* device() const { return device_; }

    static QColor ink() { return QColor(0x1c, 0x1f, 0x23); }
    static QColor quiet() { return QColor(0x5d, 0x64, 0x6c); }
    static QColor rule() { return QColor(0xc4, 0xca, 0xd0); }

private:
    QPaintDevice* device_;
    QRectF sheet_, text_area_;
    QStringList text_families_, figures_families_;
    double font_scale_ = 1.0;
};

QPageSize page_size_of(PaperSize paper);

}  // namespace covaria::ui
