#include "ui/theme/document_language.h"

#include <QTranslator>
#include <memory>

#include "ui/theme/core_text.h"
#include "ui/theme/languages.h"
#include "ui/theme/number_locale.h"

namespace covaria::ui {

DocumentLanguage document_language(const Project& project) {
    const std::string& code = project.certificate.language;
    const QString catalogue = offered_language(QString::fromStdString(code));
    auto texts = std::make_shared<QTranslator>();
    if (catalogue.isEmpty() || !texts->load(QStringLiteral(":/translations/covaria_") + catalogue)) return {};
    return {code, number_locale(QLocale(catalogue)), [texts = std::move(texts)](const std::string& english) {
                const QString said = texts->translate(core_context, english.c_str());
                return said.isEmpty() ? english : said.toStdString();
            }};
}

DocumentLanguage language_of_window() {
    return {spoken_language().toStdString(), user_numbers(), core_words};
}

}  // namespace covaria::ui
