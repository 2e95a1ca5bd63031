// Preferences are kept by QSettings, each under a key of its own.
#include "ui/theme/preferences.h"

#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <array>
#include <tuple>

#include "core/text/numbers.h"
#include "ui/theme/languages.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

const QString language_key = QStringLiteral("language"), theme_key = QStringLiteral("theme"),
              family_key = QStringLiteral("font_family"), font_key = QStringLiteral("font_points"),
              numbers_key = QStringLiteral("numbers"), units_key = QStringLiteral("results/units"),
              digits_key = QStringLiteral("results/digits"),
              autosave_key = QStringLiteral("autosave_seconds"),
              factor_key = QStringLiteral("new_analyses/coverage_factor"),
              trials_key = QStringLiteral("new_analyses/trials");

const std::array themes{QStringLiteral("system"), QStringLiteral("light"), QStringLiteral("dark")};
const std::array forms{QStringLiteral("system"), QStringLiteral("point"), QStringLiteral("comma")};

template <class Places>
std::size_t place_in(const Places& known, const QString& text) {
    const auto at = std::find(known.begin(), known.end(), text);
    return at == known.end() ? 0 : std::size_t(at - known.begin());
}

int stored_number(const QVariant& stored, int low, int high, int otherwise) {
    bool is_number = false;
    const int number = stored.toInt(&is_number);
    return is_number && number >= low && number <= high ? number : otherwise;
}

}  // namespace

Preferences Preferences::stored() {
    const QSettings settings;
    Preferences read;
    read.language = offered_language(settings.value(language_key).toString());
    read.theme = themes[place_in(themes, settings.value(theme_key).toString())];
    read.font.family = settings.value(family_key).toString();
    read.font.points = stored_number(settings.value(font_key), smallest_font, largest_font, 0);
    read.numbers = NumberForm(place_in(forms, settings.value(numbers_key).toString()));
    for (const QString& text : settings.value(units_key).toStringList())
        if (const Result<Unit> unit = Unit::parse(to_std(text))) read.units.choose(*unit);
    read.digits = stored_number(settings.value(digits_key), fewest_digits, most_digits, read.digits);
    read.autosave_seconds = stored_number(settings.value(autosave_key), 1, longest_autosave, 1);
    if (settings.value(factor_key).toDouble() == 2.0) read.coverage_factor = 2.0;
    read.trials = std::uint64_t(
        stored_number(settings.value(trials_key), int(fewest_trials), int(most_trials), int(read.trials)));
    return read;
}

bool Preferences::operator==(const Preferences& other) const {
    const auto rest = [](const Preferences& p) {
        return std::tie(p.language, p.theme, p.font.family, p.font.points, p.numbers, p.units.chosen(),
                        p.digits, p.autosave_seconds, p.coverage_factor, p.trials);
    };
    return rest(*this) == rest(other);
}

void Preferences::store() const {
    QSettings settings;
    QStringList chosen;
    for (const Unit& unit : units.chosen()) chosen << to_qt(unit.text());
    settings.setValue(language_key, language);
    settings.setValue(theme_key, theme);
    settings.setValue(family_key, font.family);
    settings.setValue(font_key, font.points);
    settings.setValue(numbers_key, forms[std::size_t(numbers)]);
    settings.setValue(units_key, chosen);
    settings.setValue(digits_key, digits);
    settings.setValue(autosave_key, autosave_seconds);
    settings.setValue(factor_key, coverage_factor.value_or(0.0));
    settings.setValue(trials_key, qulonglong(trials));
}

PreferenceStore::PreferenceStore(QObject* parent) : QObject(parent), now_(Preferences::stored()) {}

EvaluationOptions PreferenceStore::new_analysis() const {
    EvaluationOptions options;
    options.trials = now_.trials;
    options.coverage_factor = now_.coverage_factor;
    return options;
}

void PreferenceStore::set(const Preferences& wanted) {
    if (wanted == now_) return;
    now_ = wanted;
    now_.store();
    emit changed();
}

}  // namespace covaria::ui
