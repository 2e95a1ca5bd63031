// Parsing and writing of quantities in the user's locale.
#include "ui/document/quantity_text.h"

#include <QRegularExpression>
#include <cmath>

#include "core/text/digit_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

QString plain_number(QString text) {
    text = with_plain_exponent(text).trimmed().replace(QChar(0x2212), '-');
    for (const char16_t space : {u'\u00a0', u'\u202f', u'\u2009'}) text.remove(QChar(space));
    return text;
}

/// Words on a text that is no number, with what to type if its decimal sign is that of another language.
QString not_a_number(const QString& text, const QLocale& locale) {
    const QString words = tr("“%1” is not a number.").arg(text);
    const bool comma = locale.decimalPoint() == QLatin1String(",");
    QString right = text;
    right.replace(comma ? u'.' : u',', comma ? u',' : u'.');
    static const QRegularExpression number(
        QStringLiteral("^([+\\-−]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eE][+\\-−]?\\d+)?)\\s*([^\\d.,\\s].*)?$"));
    const QRegularExpressionMatch match = number.match(right);
    if (right == text || !match.hasMatch() || !parse_number(match.captured(1), locale)) return words;
    static const QRegularExpression thousands(QStringLiteral("^[+\\-−]?[1-9]\\d{0,2},\\d{3}(?!\\d)"));
    if (comma || !thousands.match(text).hasMatch())
        return words + QLatin1Char(' ') + tr("Type it as %1.").arg(right);
    return words + QLatin1Char(' ') + tr("Type it as %1, or as %2.").arg(right, QString(text).remove(u','));
}

}  // namespace

QString without_groups(const QString& text) {
    const std::string typed = to_std(text);
    const std::size_t length = length_in_groups(typed);
    return length == 0 ? text : to_qt(without_group_spaces(typed.substr(0, length)) + typed.substr(length));
}

QString with_plain_exponent(QString text) {
    static const QString figures = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    const auto power = text.indexOf(QStringLiteral("×10"));
    if (power < 0 || power + 3 >= text.size()) return text;
    QString exponent;
    for (qsizetype i = power + 3; i < text.size(); ++i) {
        const auto figure = figures.indexOf(text[i]);
        if (figure < 0 && text[i] != QChar(0x207b)) return text;
        exponent += figure < 0 ? QStringLiteral("-") : QString::number(figure);
    }
    return text.left(power) + u'e' + exponent;
}

std::optional<double> parse_number(const QString& text, const QLocale& locale) {
    const QString plain = plain_number(text);
    for (QLocale candidate : {locale, QLocale::c()}) {
        candidate.setNumberOptions(QLocale::RejectGroupSeparator);
        bool ok = false;
        const double value = candidate.toDouble(plain, &ok);
        if (ok && std::isfinite(value)) return value;
    }
    return std::nullopt;
}

Result<Unit> parse_unit(const QString& text) {
    return Unit::parse(to_std(text.trimmed()));
}

Result<std::optional<Quantity>> parse_quantity(const QString& text, const Unit& unit, const QLocale& locale) {
    static const QRegularExpression group(QStringLiteral("(?<=\\d)[\u00a0\u202f\u2009](?=\\d)"));
    const QString trimmed = without_groups(text.trimmed()).remove(group);
    if (trimmed.isEmpty()) return std::optional<Quantity>{};
    static const QRegularExpression pattern(QStringLiteral(
        "^([+\\-−]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eE][+\\-−]?\\d+|×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?)\\s*(\\S.*)?$"));
    const QRegularExpressionMatch match = pattern.match(trimmed);
    const std::optional<double> value =
        match.hasMatch() ? parse_number(match.captured(1), locale) : std::nullopt;
    if (!value) return fail(ErrorCode::bad_input, to_std(not_a_number(trimmed, locale)));
    const QString unit_text = match.captured(2);
    if (unit_text.isEmpty()) return std::optional<Quantity>(Quantity{*value, unit});
    const Result<Unit> typed = parse_unit(unit_text);
    if (!typed) return fail(ErrorCode::bad_input, to_std(tr("“%1” is not a unit.").arg(unit_text)));
    if (!(typed->dimension() == unit.dimension())) {
        const QString expected = unit.dimension().is_one()
                                     ? tr("a number without unit is expected.")
                                     : tr("a unit like %1 is expected.").arg(to_qt(unit.display()));
        return fail(ErrorCode::bad_input,
                    to_std(tr("The unit %1 does not fit here: ").arg(unit_text) + expected));
    }
    return std::optional<Quantity>(Quantity{*value, *typed});
}

std::optional<ConciseText> concise_parts(const QString& text) {
    static const QRegularExpression spaces(QStringLiteral("(?<=\\d)[ \u00a0\u202f\u2009](?=\\d)"));
    static const QRegularExpression pattern(
        QStringLiteral("^([+\\-−]?)(\\d+)([.,]?)(\\d*)\\((\\d+)(?:([.,])(\\d+))?\\)((?:[eE][+\\-−]?\\d+|×10["
                       "⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?)\\s*([^\\s(].*)?$"));
    const QRegularExpressionMatch match = pattern.match(QString(text.trimmed()).remove(spaces));
    if (!match.hasMatch()) return std::nullopt;
    const QString sign = match.captured(3), decimals = match.captured(4), power = match.captured(8);
    QString u = match.captured(5);
    if (!match.captured(6).isEmpty()) {
        u += match.captured(6) + match.captured(7);
    } else if (!decimals.isEmpty()) {
        u = u.rightJustified(decimals.size() + 1, QLatin1Char('0'));
        u.insert(u.size() - decimals.size(), sign);
    }
    const QString behind =
        power + (match.captured(9).isEmpty() ? QString() : QLatin1Char(' ') + match.captured(9));
    return ConciseText{match.captured(1) + match.captured(2) + sign + decimals + behind, u + behind};
}

QString number_text(double value, const QLocale& locale) {
    return to_qt(format_shortest(value)).replace('.', locale.decimalPoint());
}

QString quantity_text(const Quantity& quantity, const QLocale& locale) {
    // A plain space, since a narrow one cannot be typed.
    return number_text(quantity.value, locale) +
           to_qt(unit_after_number(quantity.unit)).replace(QChar(QChar::Nbsp), QChar(' '));
}

double converted(double value, const Unit& from, const Unit& to) {
    if (from == to) return value;
    return QString::number(to.from_si(from.to_si(value)), 'g', 15).toDouble();
}

double converted_interval(double value, const Unit& from, const Unit& to) {
    if (from == to) return value;
    return QString::number(to.interval_from_si(from.interval_to_si(value)), 'g', 15).toDouble();
}

}  // namespace covaria::ui
