// Paper, margins, fonts and greys of the printed report.
#include "ui/print/page_style.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QStringList>

namespace covaria::ui {
namespace {

const QStringList& sans_families() {
    static const QStringList families = {"Inter", "Liberation Sans", "DejaVu Sans"};
    return families;
}

QString first_installed(const QStringList& families) {
    const QStringList installed = QFontDatabase::families();
    for (const QString& family : families)
        if (installed.contains(family)) return family;
    return QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
}

bool has_tabular_figures(const QString& family, QPaintDevice* device) {
    QFont font(family);
    font.setPointSizeF(100.0);
    const QFontMetricsF metrics(font, device);
    const double width = metrics.horizontalAdvance('0');
    for (char digit = '1'; digit <= '9'; ++digit)
        if (std::abs(metrics.horizontalAdvance(digit) - width) > 0.01 * width) return false;
    return true;
}

QString tabular_family(const QString& fallback, QPaintDevice* device) {
    const QStringList installed = QFontDatabase::families();
    for (const QString& family : sans_families())
        if (installed.contains(family) && has_tabular_figures(family, device)) return family;
    return fallback;
}

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
    text_family_ = first_installed(sans_families());
    figures_family_ = tabular_family(text_family_, device);
}

double PageStyle::mm(double length) const {
    return length * device_->logicalDpiX() / 25.4;
}

double PageStyle::points(double length) const {
    return length * device_->logicalDpiX() / 72.0;
}

QFont PageStyle::font(TextRole role) const {
    const RoleSpec spec = spec_of(role);
    QFont font(text_family_);
    font.setPointSizeF(spec.size);
    font.setWeight(spec.weight);
    // Inter swaps marks beside figures and capitals for glyphs that PDF readers cannot map back to text.
    font.setStyleStrategy(QFont::PreferNoShaping);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

QFont PageStyle::figures_font() const {
    QFont font(figures_family_);
    font.setPointSizeF(spec_of(TextRole::table).size);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

}  // namespace covaria::ui
