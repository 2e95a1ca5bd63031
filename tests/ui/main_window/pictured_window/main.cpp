// Pictures of the real window for people to look at: start page, every example with every entry and every
// tab, preferences and library. usage: pictured_window FOLDER LANGUAGE light|dark WIDTH HEIGHT [PROJECT ...]
// (without projects: all examples). What is cut in them is in cut.txt, each text once, with the
// picture; all of them small on one sheet are in contact.png.
#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "tests/ui/main_window/cut_texts.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/theme_switch.h"
#include "ui/pages/library_browser.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/report_preview.h"
#include "ui/pages/results_pane.h"
#include "ui/scene_view/scene_panel.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/languages.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

class Camera {
public:
    Camera(const QDir& folder, const QString& theme, const QSize& size) : folder_(folder) {
        folder_.mkpath(QStringLiteral("."));
        (void)list_.open(QIODevice::WriteOnly);
        Dialogs& dialogs = window_.files().dialogs;
        dialogs.save_changes = [](const QString&) { return SaveAnswer::discard; };
        dialogs.confirm = [](const QString&, const QString&) { return true; };
        dialogs.show_message = [](const QString&, const QString&) {};
        window_.findChild<ThemeSwitch*>()->choose(theme);
        window_.resize(size);
        window_.show();
    }
    ~Camera() {
        window_.runner().stop_all();
        window_.runner().wait_until_idle(20'000);
        window_.close();
    }

    void shoot_what_needs_no_project() {
        shoot(window_, QStringLiteral("start"));
        PreferencesDialog preferences(window_.preferences());
        preferences.show();
        const QTabWidget* parts = preferences.findChild<QTabWidget*>();
        for (int i = 0; i < (parts ? parts->count() : 1); ++i) {
            if (parts) preferences.findChild<QTabWidget*>()->setCurrentIndex(i);
            shoot(preferences, QStringLiteral("preferences-%1").arg(i));
        }
        window_.library().fill();
        window_.library().show();
        shoot(window_.library(), QStringLiteral("library"));
        window_.library().hide();
    }

    void shoot_project(const QString& file) {
        const QString name = QFileInfo(file).completeBaseName();
        QSignalSpy opened(&window_.document(), &Document::open_finished);
        window_.files().open_file(file);
        if (!opened.wait(10'000)) return;
        window_.runner().wait_until_idle(120'000);
        const Project project = window_.document().project();
        for (const AssetEntry& asset : project.assets) {
            window_.selection().select_entry({SetupOwner::asset, asset.id});
            shoot_groups(name + QLatin1Char('-') + to_qt(asset.id));
        }
        for (const AnalysisEntry& analysis : project.analyses) {
            window_.selection().select_entry({SetupOwner::analysis, analysis.id});
            const QString start = name + QLatin1Char('-') + to_qt(analysis.id);
            shoot_groups(start);
            shoot_tabs(window_.results().tabs(), start + QStringLiteral("-result"));
        }
    }

    /// All pictures on one sheet, small: contact.png.
    void draw_contact_sheet() const {
        constexpr int columns = 5, gap = 12, for_name = 18;
        int height = gap;
        const auto each_row = [&](const auto& take) {
            for (qsizetype first = 0; first < contacts_.size(); first += columns) {
                int tallest = 0;
                for (qsizetype i = first; i < std::min(first + columns, contacts_.size()); ++i)
                    tallest = std::max(tallest, contacts_[i].picture.height());
                take(first, tallest);
            }
        };
        each_row([&](qsizetype, int tallest) { height += tallest + for_name + gap; });
        QImage sheet(gap + columns * (contact_width + gap), height, QImage::Format_RGB32);
        sheet.fill(Qt::white);
        QPainter painter(&sheet);
        int y = gap;
        each_row([&](qsizetype first, int tallest) {
            for (qsizetype i = first; i < std::min(first + columns, contacts_.size()); ++i) {
                const int x = gap + int(i - first) * (contact_width + gap);
                painter.drawText(QRect(x, y, contact_width, for_name), Qt::AlignLeft, contacts_[i].name);
                painter.drawImage(x, y + for_name, contacts_[i].picture);
            }
            y += tallest + for_name + gap;
        });
        painter.end();
        sheet.save(folder_.filePath(QStringLiteral("contact.png")));
    }

private:
    static constexpr int contact_width = 360;  // px
    struct Contact {
        QString name;
        QImage picture;
    };
    /// Shoots the inspector as it is found, and then each group with its head at the top.
    void shoot_groups(const QString& start) {
        shoot(window_, start);
        FoldGroups& groups = window_.properties().groups();
        for (int i = 0; i < groups.count(); ++i) {
            if (groups.title(i).isEmpty()) continue;
            window_.properties().show_group(i);
            QTest::qWait(20);
            shoot(window_, QStringLiteral("%1-%2").arg(start).arg(i));
        }
    }
    void shoot_tabs(QTabWidget& tabs, const QString& start) {
        const int before = tabs.currentIndex();
        for (int i = 0; i < tabs.count(); ++i) {
            if (!tabs.isTabVisible(i) || !tabs.isTabEnabled(i)) continue;
            tabs.setCurrentIndex(i);
            if (auto* report = qobject_cast<ReportPreview*>(tabs.widget(i)))
                (void)QTest::qWaitFor([&] { return report->page_count() > 0; }, 120'000);
            shoot(window_, QStringLiteral("%1-%2").arg(start).arg(i));
        }
        tabs.setCurrentIndex(before);
    }
    void shoot(QWidget& widget, const QString& name) {
        (void)QTest::qWaitFor([this] { return !window_.scene().is_building(); }, 30'000);
        window_.scene().view().service().wait_until_idle();
        QTest::qWait(50);
        const QPixmap picture = widget.grab();
        picture.save(folder_.filePath(name + QStringLiteral(".png")));
        contacts_.push_back({name, picture.toImage().scaledToWidth(contact_width, Qt::SmoothTransformation)});
        for (const QString& text : cut_texts(widget)) {
            if (cut_.contains(text)) continue;
            cut_.insert(text);
            QTextStream(&list_) << name << ": " << text << '\n';
        }
    }

    QDir folder_;
    QFile list_{folder_.filePath(QStringLiteral("cut.txt"))};
    QSet<QString> cut_;
    QList<Contact> contacts_;
    QTemporaryDir recovery_;
    MainWindow window_{RecoveryStore(recovery_.path())};
};

}  // namespace
}  // namespace covaria::ui

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const QTemporaryDir settings;
    QCoreApplication::setOrganizationName(QStringLiteral("CovariaPictures"));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    const QStringList words = QCoreApplication::arguments();
    if (words.size() < 6) return 2;
    covaria::ui::speak_as_preferred(words[2]);
    QStringList files = words.mid(6);
    if (files.isEmpty())
        for (const char* folder : {"/projects", "/projects/gum"})
            for (const QFileInfo& info : QDir(QStringLiteral(COVARIA_SOURCE_DIR) + QLatin1String(folder))
                                             .entryInfoList({QStringLiteral("*.covaria")}, QDir::Files))
                files << info.filePath();
    covaria::ui::Camera camera(QDir(words[1]), words[3], QSize(words[4].toInt(), words[5].toInt()));
    camera.shoot_what_needs_no_project();
    for (const QString& file : files) camera.shoot_project(file);
    camera.draw_contact_sheet();
    return 0;
}
