#include "ui/theme/languages.h"

#include <QCoreApplication>
#include <QFile>
#include <QTranslator>
#include <algorithm>

#include "ui/theme/preferences.h"

static void load_resources() {  // Q_INIT_RESOURCE stands in no namespace
    Q_INIT_RESOURCE(translations);
}

namespace covaria::ui {
namespace {

const QString folder_of_catalogues = QStringLiteral(":/translations/");
const QString english = QStringLiteral("en");

std::vector<Language> read_languages() {
    load_resources();
    std::vector<Language> read{{english, QStringLiteral("English"), {}, true}};
    QFile list(folder_of_catalogues + QStringLiteral("languages.txt"));
    if (!list.open(QIODevice::ReadOnly)) return read;
    for (const QString& line : QString::fromUtf8(list.readAll()).split(QLatin1Char('\n'))) {
        const QStringList parts = line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        if (parts.size() != 4 || line.startsWith(QLatin1Char('#'))) continue;
        read.push_back({parts[0], parts[1], parts[2], parts[3] == QLatin1String("offered")});
    }
    return read;
}

/// The first part of "zh_CN", "pt-BR".
QString bare_language(const QString& code) {
    return code.left(code.indexOf(QLatin1Char('_')));
}

QString& said_language() {
    static QString code = english;
    return code;
}

void install(const QString& catalogue) {
    auto* texts = new QTranslator(QCoreApplication::instance());
    if (texts->load(folder_of_catalogues + catalogue + QStringLiteral(".qm")))
        QCoreApplication::installTranslator(texts);
    else
        delete texts;
}

}  // namespace

const std::vector<Language>& all_languages() {
    static const std::vector<Language> all = read_languages();
    return all;
}

std::vector<Language> offered_languages() {
    std::vector<Language> offered;
    std::ranges::copy_if(all_languages(), std::back_inserter(offered), &Language::is_offered);
    return offered;
}

QString offered_language(const QString& code) {
    const QString wanted = QString(code).replace(QLatin1Char('-'), QLatin1Char('_'));
    const std::vector<Language> offered = offered_languages();
    if (std::ranges::count(offered, wanted, &Language::code) > 0) return wanted;
    const auto same = std::ranges::find_if(offered, [&](const Language& language) {
        return bare_language(language.code) == bare_language(wanted);
    });
    // Chinese is written in two ways.
    const bool traditional = wanted.contains(QLatin1String("TW")) || wanted.contains(QLatin1String("HK")) ||
                             wanted.contains(QLatin1String("Hant"));
    return same == offered.end() || traditional ? QString() : same->code;
}

QString language_to_speak(const QString& chosen, const QLocale& system) {
    if (const QString found = chosen.isEmpty() ? QString() : offered_language(chosen); !found.isEmpty())
        return found;
    for (const QString& spoken : system.uiLanguages())
        if (const QString found = offered_language(spoken); !found.isEmpty()) return found;
    return english;
}

void speak(const QString& code, bool chosen) {
    said_language() = code;
    if (chosen) QLocale::setDefault(QLocale(code));
    const auto language = std::ranges::find(all_languages(), code, &Language::code);
    if (language == all_languages().end() || code == english) return;
    install(language->qt_catalogue);
    install(QStringLiteral("covaria_") + code);  // asked first
}

QString spoken_language() {
    return said_language();
}

void speak_as_preferred(const QString& this_time) {
    const QString chosen = this_time.isEmpty() ? Preferences::stored().language : offered_language(this_time);
    speak(language_to_speak(chosen, QLocale::system()), !chosen.isEmpty());
}

}  // namespace covaria::ui
