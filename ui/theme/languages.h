// The languages that the window speaks: catalogues of Qt Linguist in the program, and the choice among them.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace covaria::ui {

struct Language {
    QString code;             ///< part of the catalogue's name: "de", "zh_CN"
    QString name;             ///< in the language itself
    QString qt_catalogue;     ///< catalogue of Qt's texts: "qtbase_de"; empty: they are in the program
    bool is_offered = false;  ///< its catalogue has no gaps
};

/// Languages of resources/translations/languages.txt in its order, after English.
const std::vector<Language>& all_languages();
/// Languages that people may choose.
std::vector<Language> offered_languages();
/// The language of that code, or of the same language in another country ("de_AT"); empty: none is offered.
QString offered_language(const QString& code);
/// Language that the window is to speak: `chosen` where it is offered; with an empty one, the first of the
/// system's languages that is; else English.
QString language_to_speak(const QString& chosen, const QLocale& system);

/// Speaks that language from now on; to be said before there is a window. Where it
/// was `chosen`, numbers follow it, too: QLocale() is the language's.
void speak(const QString& code, bool chosen);
/// Code of the language that the window speaks; "en" until it was said.
QString spoken_language();

/// Speaks the language of the preferences, or `this_time` where it is not empty.
void speak_as_preferred(const QString& this_time);

}  // namespace covaria::ui
