// Spaces at which no line breaks: between a number and its unit, around "=", after an abbreviation.
#include "ui/print/kept_spaces.h"

#include <algorithm>

#include "core/base/unit.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

constexpr qsizetype longest_run = 28;          // relations hold together: longer ones break behind the sign
constexpr qsizetype longest_abbreviation = 5;  // "Abs."

bool is_relation(QStringView word) {
    static const QString signs = QStringLiteral("=±≤≥<>≈×·");
    return word.size() == 1 && signs.contains(word.front());
}

bool ends_a_number(QStringView word) {
    static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    return !word.empty() && (word.back().isDigit() || raised.contains(word.back()));
}

bool is_unit(QStringView word) {
    while (!word.empty() && QStringView(u".,;:)]").contains(word.back())) word.chop(1);
    if (word.empty() || word.front().isDigit()) return false;
    return Unit::parse(to_std(word.toString())).has_value();
}

/// "d. 1", "H. 1", "Eq. 2".
bool is_abbreviation(QStringView word) {
    while (!word.empty() && word.front() == u'(') word = word.sliced(1);
    return word.size() > 1 && word.size() <= longest_abbreviation && word.back() == u'.' &&
           word.front().isLetter();
}

/// "20 000".
bool is_group_of_digits(QStringView before, QStringView after) {
    const auto figures = [](QStringView word) {
        return std::all_of(word.begin(), word.end(), [](QChar letter) { return letter.isDigit(); });
    };
    return after.size() == 3 && before.size() <= 3 && figures(before) && figures(after);
}

/// `run`: letters since the last space at which a line may break.
bool stays(QStringView before, QStringView after, qsizetype run) {
    if (before.empty() || after.empty()) return false;
    if (is_relation(after)) return run <= longest_run;
    if (is_relation(before)) return run + after.size() <= longest_run;
    if (is_abbreviation(before)) return after.front().isDigit();
    return ends_a_number(before) && (is_unit(after) || is_group_of_digits(before, after));
}

bool is_space(QChar letter) {
    return letter == u' ' || letter == QChar::LineSeparator || letter == QChar::ParagraphSeparator;
}

}  // namespace

QString with_kept_spaces(const QString& text) {
    QString kept = text;
    const QStringView all = text;
    qsizetype word = 0, run = 0;  // the beginnings of the word and of the run before this space
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (!is_space(text[i])) continue;
        const auto next = std::find_if(text.begin() + i + 1, text.end(), is_space);
        const QStringView after = all.sliced(i + 1, next - text.begin() - i - 1);
        if (text[i] == u' ' && stays(all.sliced(word, i - word), after, i - run))
            kept[i] = QChar::Nbsp;
        else
            run = i + 1;
        word = i + 1;
    }
    return kept;
}

}  // namespace covaria::ui
