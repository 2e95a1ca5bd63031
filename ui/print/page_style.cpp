// Paper, margins, fonts and greys of the printed report.
#include "ui/print/page_style.h"

#include "ui/theme/fonts.h"

namespace covaria::ui {
namespace {

struct RoleSpec {
    double size;
    QFont::Weight weight;
};

RoleSpec spec_of(TextRole role) {
    switch (role) {
        case TextRole::title:
            return {17.0, QFont::DemiBold};
        case TextRole::heading_1:
            return {12.5, QFont::DemiBold};
        case TextRole::heading_2:
            return {10.0, QFont::DemiBold};
        case TextRole::heading_3:
            return {8.8, QFont::DemiBold};
        case TextRole::body:
            return {8.8, QFont::Normal};
        case TextRole::note:
            return {7.4, QFont::Normal};
        case TextRole::table:
            return {7.6, QFont::Normal};
        case TextRole::table_head:
            return {7.4, QFont::Medium};
        case TextRole::caption:
            return {8.0, QFont::Medium};
        case TextRole::running:
            return {7.4, QFont::Normal};
    }
    return {8.8, QFont::Normal};
}

}  // namespace

QPageSize page_size_of(PaperSize paper) {
    return QPageSize(paper == PaperSize::a4 ? QPageSize::A4 : QPageSize::Letter);
}

PageStyle::PageStyle(QPaintDevice* device, PaperSize paper) : device_(device) {
    const QSizeF millimetres = page_size_of(paper).size(QPageSize::Millimeter);
    sheet_ = QRectF(0.0, 0.0, mm(millimetres.width()), mm(millimetres.height()));
    text_area_ = sheet_.adjusted(mm(20.0), mm(25.0), -mm(20.0), -mm(22.0));
    text_families_ = text_families();
    figures_families_ = figures_families();
}

PageStyle PageStyle::with_fonts(double scale) const {
    PageStyle scaled = *this;
    scaled.font_scale_ *= scale;
    return scaled;
}

double PageStyle::mm(double length) const {
    return length * device_->logicalDpiX() / 25.4;
}

double PageStyle::points(double length) const {
    return length * device_->logicalDpiX() / 72.0;
}

QFont PageStyle::font(TextRole role) const {
    const RoleSpec spec = spec_of(role);
    QFont font(text_families_);
    font.setPointSizeF(font_scale_ * spec.size);
    font.setWeight(spec.weight);
    // Inter swaps marks beside figures and capitals for glyphs that PDF readers cannot map back to text.
    font.setStyleStrategy(QFont::PreferNoShaping);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

QFont PageStyle::figures_font() const {
    QFont font(figures_families_);
    font.setPointSizeF(font_scale_ * spec_of(TextRole::table).size);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

}  // namespace covaria::ui
