#include "ui/theme/languages.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>
#include <algorithm>

#include "ui/theme/core_text.h"
#include "ui/theme/document_language.h"
#include "ui/theme/preferences.h"

namespace covaria::ui::languages_test {
namespace {

TEST(Languages, CataloguesAreInTheProgram) {
    ASSERT_EQ(all_languages().size(), 6u);
    EXPECT_EQ(all_languages().front().code, QStringLiteral("en"));
    for (const Language& language : all_languages()) {
        if (language.code == QLatin1String("en")) continue;
        QTranslator own;
        EXPECT_TRUE(own.load(QStringLiteral(":/translations/covaria_%1.qm").arg(language.code)));
        EXPECT_EQ(own.language(), language.code);
        EXPECT_FALSE(language.is_offered && own.isEmpty()) << language.name.toStdString();
        QTranslator of_qt;
        ASSERT_TRUE(of_qt.load(QStringLiteral(":/translations/%1.qm").arg(language.qt_catalogue)));
        EXPECT_FALSE(of_qt.translate("QPlatformTheme", "Cancel").isEmpty()) << language.name.toStdString();
    }
}

TEST(Languages, OnlyWhatIsOfferedIsSpoken) {
    EXPECT_EQ(offered_language(QStringLiteral("en")), QStringLiteral("en"));
    EXPECT_EQ(offered_language(QStringLiteral("en-GB")), QStringLiteral("en"));
    EXPECT_EQ(offered_language(QStringLiteral("xx")), QString());
    EXPECT_EQ(offered_language({}), QString());
    EXPECT_EQ(offered_language(QStringLiteral("zh_TW")), QString()) << "it is written otherwise";
    EXPECT_EQ(language_to_speak(QStringLiteral("xx"), QLocale(QLocale::Finnish)), QStringLiteral("en"));
    for (const Language& language : all_languages()) {
        const QString spoken = language.is_offered ? language.code : QStringLiteral("en");
        EXPECT_EQ(language_to_speak(language.code, QLocale::c()), spoken);
        EXPECT_EQ(language_to_speak({}, QLocale(language.code)), spoken);
        EXPECT_EQ(language_to_speak(QStringLiteral("en"), QLocale(language.code)), QStringLiteral("en"));
    }
}

TEST(Languages, TextsOfTheCoreAreLookedUpAndNamesStay) {
    class Shouting : public QTranslator {
    public:
        bool isEmpty() const override { return false; }
        QString translate(const char* context, const char* text, const char*, int) const override {
            const bool is_known = QLatin1String(context) == QLatin1String("core") &&
                                  QLatin1String(text) == QLatin1String("Estimate");
            return is_known ? QStringLiteral("ESTIMATE") : QString();
        }
    } shouting;
    QCoreApplication::installTranslator(&shouting);
    EXPECT_EQ(core_text("Estimate"), QStringLiteral("ESTIMATE"));
    EXPECT_EQ(core_words("My tracker"), "My tracker");
    EXPECT_EQ(core_text(""), QString());
    EXPECT_EQ(core_title(Text("Estimate")), Text("ESTIMATE"));
    const Text symbol = Text("Estimate") + Text(Text::Span{"c", Script::below, false});
    EXPECT_EQ(core_title(symbol), symbol);
    QCoreApplication::removeTranslator(&shouting);
}

TEST(DocumentLanguages, CertificatesHaveTheLanguagesOfTheWindow) {
    std::vector<std::pair<QString, QString>> certificates, windows;
    for (const CertificateLanguage& language : certificate_languages())
        certificates.emplace_back(QString::fromUtf8(language.code), QString::fromUtf8(language.name));
    for (const Language& language : offered_languages()) windows.emplace_back(language.code, language.name);
    EXPECT_EQ(certificates, windows);
}

TEST(DocumentLanguages, SayPhrasesAndWriteNumbers) {
    Project project;
    EXPECT_EQ(document_language(project).say_declared("Decision rule"), "Decision rule");
    project.certificate.language = "de";
    const DocumentLanguage german = document_language(project);
    EXPECT_EQ(german.code(), "de");
    EXPECT_EQ(german.numbers().decimal, ",");
    EXPECT_EQ(german.say_declared("Decision rule"), "Entscheidungsregel");
    EXPECT_EQ(german.say_declared("a name that somebody gave"), "a name that somebody gave");
    project.certificate.language = "xx";
    EXPECT_EQ(document_language(project).code(), "en");
}

/// The last one: the application keeps the language.
TEST(Languages, ThatOfTheWindowIsTheOneItWasToldToSpeak) {
    EXPECT_EQ(language_of_window().code(), "en");
    speak(QStringLiteral("de"), true);
    EXPECT_EQ(language_of_window().code(), "de") << "not de_DE: pages of help are found by it";
    EXPECT_EQ(language_of_window().say_declared("Decision rule"), "Entscheidungsregel");
    EXPECT_EQ(language_of_window().numbers().decimal, ",");
}

}  // namespace
}  // namespace covaria::ui::languages_test
