// The window in a language of which only the texts are known: every text is its English one in brackets,
// longer by a third. What has no brackets goes through no catalogue; what is asked for and is in none was not
// extracted.
#include <QAbstractButton>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QTabBar>
#include <QTableView>
#include <QTranslator>
#include <QXmlStreamReader>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/pages/library_browser.h"
#include "ui/theme/core_text.h"

namespace covaria::ui::language_test {
namespace {

const QChar opening(0x27e6), closing(0x27e7);  // ⟦ ⟧

using Key = std::pair<QString, QString>;  // context, source

QSet<Key> texts_of_catalogue(const QString& code) {
    QFile file(QStringLiteral(COVARIA_SOURCE_DIR "/resources/translations/covaria_%1.ts").arg(code));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader in(&file);
    QSet<Key> all;
    QString context;
    while (!in.atEnd()) {
        if (in.readNext() != QXmlStreamReader::StartElement) continue;
        if (in.name() == QLatin1String("name")) context = in.readElementText();
        if (in.name() == QLatin1String("source")) all.insert({context, in.readElementText()});
    }
    EXPECT_GT(all.size(), 1000);
    return all;
}

class Brackets : public QTranslator {
public:
    Brackets() : known_(texts_of_catalogue(QStringLiteral("de"))) {}
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char*, int) const override {
        const QString of = QString::fromUtf8(context), text = QString::fromUtf8(source);
        if (known_.contains({of, text})) return opening + text + closing;
        if (of.startsWith(QLatin1String("covaria::ui")) || of == QLatin1String("QObject"))
            unknown_.insert(of + QStringLiteral(": ") + text);
        return {};
    }
    QStringList unknown() const { return unknown_.values(); }

private:
    QSet<Key> known_;
    mutable QSet<QString> unknown_;
};

class Languages : public Session {
protected:
    Languages() {
        QCoreApplication::installTranslator(&brackets_);
        window_->close();
        make_window();
    }
    ~Languages() override { QCoreApplication::removeTranslator(&brackets_); }

    /// Words that stand in no brackets.
    static QString untranslated(QString text) {
        static const QRegularExpression in_brackets(QStringLiteral("\u27e6[^\u27e6\u27e7]*\u27e7")),
            markup(QStringLiteral("<[^<>]*>|&[a-z]+;")), word(QStringLiteral("[a-z]{3,}"));
        for (QString before; before != text;) {
            before = text;
            text.remove(in_brackets);
        }
        return word.match(text.remove(markup)).hasMatch() ? text.trimmed() : QString();
    }
    void look_at(const QString& place, const QString& text) {
        if (const QString words = untranslated(text); !words.isEmpty())
            found_.insert(place + QStringLiteral(": ") + words);
    }
    void look_at_head(const QAbstractItemModel& model, const QString& place) {
        for (int c = 0; c < model.columnCount(); ++c)
            for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole)})
                look_at(place, model.headerData(c, Qt::Horizontal, role).toString());
    }
    void look_at(QWidget& widget) {
        const QString place =
            QString::fromLatin1(widget.metaObject()->className()) + QLatin1Char(' ') + widget.objectName();
        look_at(place + QStringLiteral(" tip"), widget.toolTip());
        look_at(place + QStringLiteral(" name"), widget.accessibleName());
        if (auto* label = qobject_cast<QLabel*>(&widget)) look_at(place, label->text());
        if (auto* button = qobject_cast<QAbstractButton*>(&widget)) look_at(place, button->text());
        if (auto* group = qobject_cast<QGroupBox*>(&widget)) look_at(place, group->title());
        if (auto* line = qobject_cast<QLineEdit*>(&widget)) look_at(place, line->placeholderText());
        if (auto* box = qobject_cast<QComboBox*>(&widget))
            for (int i = 0; i < box->count(); ++i) look_at(place, box->itemText(i));
        if (auto* bar = qobject_cast<QTabBar*>(&widget))
            for (int i = 0; i < bar->count(); ++i) look_at(place, bar->tabText(i));
        if (auto* table = qobject_cast<QTableView*>(&widget); table && table->model())
            look_at_head(*table->model(), place);
        for (QAction* action : widget.actions()) {
            look_at(place + QStringLiteral(" action"), action->text());
            look_at(place + QStringLiteral(" action tip"), action->toolTip());
        }
    }
    void look_at_all(QWidget& top) {
        look_at(top);
        for (QWidget* widget : top.findChildren<QWidget*>()) look_at(*widget);
    }

    Brackets brackets_;
    QSet<QString> found_;
};

TEST_F(Languages, DiscoverTexts) {
    open(project_copy(QStringLiteral("stewart-platform")));
    wait_until_idle();
    look_at_all(*window_);
    for (const AssetEntry& asset : window_->document().project().assets) {
        select(SetupOwner::asset, asset.id);
        settle();
        look_at_all(*window_);
    }
    LibraryBrowser browser;
    look_at_all(browser);
    QStringList all = found_.values();
    all.sort();
    for (const QString& one : all) puts(("FOUND " + one).toUtf8().constData());
    EXPECT_EQ(brackets_.unknown(), QStringList());
}

}  // namespace
}  // namespace covaria::ui::language_test
