// Choice of fonts among those installed.
#include "ui/theme/fonts.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QHash>
#include <QLocale>
#include <QMutex>
#include <QStringList>
#include <cmath>

namespace covaria::ui {
namespace {

QStringList installed_of_ours() {
    const QStringList installed = QFontDatabase::families();
    QStringList ours;
    for (const char* family : {"Inter", "Liberation Sans", "DejaVu Sans"})
        if (installed.contains(QLatin1String(family))) ours << QLatin1String(family);
    ours << QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
    return ours;
}

bool measure_figures(const QString& family) {
    QFont font(family);
    font.setPixelSize(100);
    font.setHintingPreference(QFont::PreferNoHinting);
    const QFontMetricsF metrics(font);
    const double width = metrics.horizontalAdvance(u'0');
    for (char16_t digit = u'1'; digit <= u'9'; ++digit)
        if (std::abs(metrics.horizontalAdvance(QChar(digit)) - width) > 0.5) return false;
    return true;
}

bool has_tabular_figures(const QString& family) {
    static QHash<QString, bool> known;  // shared by the window's thread and those that print
    static QMutex mutex;
    const QMutexLocker lock(&mutex);
    const auto found = known.constFind(family);
    return found != known.constEnd() ? *found : *known.insert(family, measure_figures(family));
}

/// Family of letters that our families lack: Han letters have another form in each language.
QString han_family() {
    switch (QLocale().language()) {
        case QLocale::Korean:
            return QStringLiteral("Noto Sans CJK KR");
        case QLocale::Japanese:
            return QStringLiteral("Noto Sans CJK JP");
        default:
            return QStringLiteral("Noto Sans CJK SC");
    }
}

/// Letters that the family lacks (superscript capitals, arrows) come from families that are named, in this
/// order: else fontconfig chooses by the locale of the environment, and lines of a report are higher where
/// somebody else lives.
QStringList with_fallbacks(const QString& family) {
    QStringList families{family};
    static const QStringList installed = QFontDatabase::families();  // hundreds, asked for with every label
    for (const QString& other :
         {QStringLiteral("DejaVu Sans"), QStringLiteral("Liberation Sans"), han_family()})
        if (other != family && installed.contains(other)) families << other;
    return families;
}

QFont times(QFont font, double factor) {
    if (font.pointSizeF() > 0)
        font.setPointSizeF(factor * font.pointSizeF());
    else
        font.setPixelSize(qRound(factor * font.pixelSize()));
    return font;
}

}  // namespace

QStringList text_families() {
    return with_fallbacks(text_family());
}

QStringList figures_families() {
    return with_fallbacks(figures_family());
}

QString text_family() {
    static const QString family = installed_of_ours().constFirst();
    return family;
}

QString figures_family() {
    static const QString family = [] {
        for (const QString& candidate : installed_of_ours())
            if (has_tabular_figures(candidate)) return candidate;
        return text_family();
    }();
    return family;
}

QFont application_font(const FontChoice& chosen) {
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    const bool is_ours = chosen.family.isEmpty() || !QFontDatabase::hasFamily(chosen.family);
    font.setFamilies(with_fallbacks(is_ours ? text_family() : chosen.family));
    if (chosen.points > 0) font.setPointSize(chosen.points);
    return font;
}

QFont sized(QFont font, TextSize size) {
    constexpr double text = 13.0, answer = 20.0, title = 15.0, small = 11.0;
    const double wanted = size == TextSize::answer  ? answer
                          : size == TextSize::title ? title
                          : size == TextSize::small ? small
                                                    : text;
    if (wanted > text) font.setWeight(QFont::DemiBold);
    return times(std::move(font), wanted / text);
}

QFont formula_font(QFont font) {
    constexpr double larger = 1.14;
    static const QStringList families = [] {
        const QStringList installed = QFontDatabase::families();
        QStringList found;
        for (const char* family : {"STIXGeneral", "STIX", "Liberation Serif", "DejaVu Serif"})
            if (installed.contains(QLatin1String(family))) found << QLatin1String(family);
        return found;
    }();
    if (families.isEmpty() || families.contains(font.families().value(0))) return font;
    font.setFamilies(families + with_fallbacks(text_family()));
    return times(std::move(font), larger);
}

QFont symbol_font(QFont font) {
    font = formula_font(std::move(font));
    font.setItalic(true);
    return font;
}

QFont with_tabular_figures(QFont font) {
    const QString family = QGuiApplication::font().families().value(0);
    const bool is_chosen = font.families().value(0) == family && family != text_family();
    font.setFamilies(with_fallbacks(is_chosen && has_tabular_figures(family) ? family : figures_family()));
    return font;
}

}  // namespace covaria::ui
