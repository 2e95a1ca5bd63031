// Entries of a menu have different letters for Alt, in every language.
#include <QMenu>
#include <QMenuBar>
#include <QTranslator>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/theme/languages.h"

namespace covaria::ui::mnemonics_test {
namespace {

class Mnemonics : public Session {
protected:
    void make_window_in(const QString& code) {
        if (code != QLatin1String("en")) {
            ASSERT_TRUE(texts_.load(QStringLiteral(":/translations/covaria_%1.qm").arg(code)));
            QCoreApplication::installTranslator(&texts_);
        }
        window_->close();
        make_window();
    }
    ~Mnemonics() override { QCoreApplication::removeTranslator(&texts_); }

    static void look_at(const QString& place, const QList<QAction*>& actions) {
        QMap<QString, QString> entries;  // by letter
        for (const QAction* action : actions) {
            if (action->menu())
                look_at(place + QStringLiteral(" > ") + action->text(), action->menu()->actions());
            const QString letter = QKeySequence::mnemonic(action->text()).toString();
            if (letter.isEmpty()) continue;
            EXPECT_FALSE(entries.contains(letter)) << to_std(
                place + QStringLiteral(": '%1' and '%2'").arg(entries.value(letter), action->text()));
            entries[letter] = action->text();
        }
    }

    QTranslator texts_;
};

TEST_F(Mnemonics, AreDistinctInEveryMenuAndLanguage) {
    for (const Language& language : all_languages()) {
        if (!language.is_offered) continue;
        make_window_in(language.code);
        look_at(language.code, window_->menuBar()->actions());
        QCoreApplication::removeTranslator(&texts_);
    }
}

}  // namespace
}  // namespace covaria::ui::mnemonics_test
