#include "ui/main_window/help_actions.h"

#include <Eigen/Core>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QShortcut>

#include "core/base/version.h"
#include "core/kinds/registries.h"
#include "ui/document/setup_address.h"
#include "ui/forms/help_place.h"
#include "ui/main_window/dock_title.h"
#include "ui/pages/help_pane.h"
#include "ui/theme/core_text.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"
#include "viz/vtk/vtk_version.h"

namespace covaria::ui {
namespace {

QString keys_text() {
    return tr(
        "# Keys\n\n"
        "| Key | Does |\n|---|---|\n"
        "| Ctrl+N, Ctrl+O, Ctrl+S | new, open, save |\n"
        "| Ctrl+Z; Ctrl+Shift+Z or Ctrl+Y | undo; redo |\n"
        "| F6, Shift+F6 | next, previous pane |\n"
        "| F11 | the budget or the scene alone, and back |\n"
        "| Tab, Shift+Tab in a table | next, previous cell, and on behind the last one; with Ctrl out of the "
        "table at once |\n"
        "| Ctrl+R in a budget | correlation coefficient of the two rows that are selected |\n"
        "| F5, Ctrl+F5, Esc | run this analysis, run all, stop |\n"
        "| F2, Ctrl+D, Delete | rename, duplicate, delete the selected entry |\n"
        "| Arrow keys, + and − | turn and zoom the scene |\n"
        "| 1 to 7, F | iso, top, front, right, bottom, back, left view, fit (Ctrl+1 to Ctrl+7 anywhere) |\n"
        "| H, I, Shift+H | hide what is selected in the scene, show it alone, show all |\n"
        "| Drag in the scene | moves a thing, turns it by the tip of an axis; with Ctrl in round steps |\n"
        "| D, A | measure a distance, an angle in the scene; Esc puts the tool away |\n"
        "| +, −, Ctrl+wheel in the report | larger, smaller pages; Alt+Up and Alt+Down: previous, next page "
        "|\n"
        "| Ctrl+C, Ctrl+V | copy and paste blocks of cells |\n"
        "| Ctrl+K | find anything: analyses, quantities, results, fields, commands, help |\n"
        "| F1 | help on the field, cell or entry with the focus |\n");
}

QString eigen_version() {
    return QStringLiteral("%1.%2.%3")
        .arg(EIGEN_WORLD_VERSION)
        .arg(EIGEN_MAJOR_VERSION)
        .arg(EIGEN_MINOR_VERSION);
}

void show_about(QWidget& window) {
    QMessageBox box(&window);
    box.setWindowTitle(tr("About Covaria"));
    box.setIconPixmap(icon(QStringLiteral("covaria")).pixmap(QSize(64, 64), window.devicePixelRatioF()));
    box.setText(about_text());
    box.exec();
}

}  // namespace

QString about_text() {
    return tr("<h3>Covaria %1</h3><p>Measurement uncertainty of robots and large-scale metrology.<br>"
              "Evaluates by JCGM 100, 101 and 102.</p><p>Qt %2, VTK %3, Eigen %4</p>")
        .arg(QString::fromLatin1(version()), QString::fromLatin1(qVersion()), to_qt(vtk_version()),
             eigen_version());
}

HelpActions::HelpActions(QMainWindow& window, Selection& selection, Document& document)
    : QObject(&window), window_(window), selection_(selection), document_(document) {}

HelpPane& HelpActions::pane() {
    if (pane_) return *pane_;
    dock_ = new QDockWidget(tr("Help"), &window_);
    dock_->setObjectName(QStringLiteral("help_dock"));
    dock_->setTitleBarWidget(new DockTitle(*dock_, nullptr));
    pane_ = new HelpPane(dock_);
    dock_->setWidget(pane_);
    auto* leave = new QShortcut(Qt::Key_Escape, dock_, [this] {
        hide();
        if (before_) before_->setFocus();
    });
    leave->setContext(Qt::WidgetWithChildrenShortcut);
    window_.addDockWidget(Qt::RightDockWidgetArea, dock_);
    window_.resizeDocks({dock_}, {(2 * window_.height()) / 5}, Qt::Vertical);
    connect(pane_, &HelpPane::title_changed, dock_, &QWidget::setWindowTitle);
    return *pane_;
}

void HelpActions::show_dock() {
    dock_->show();
    dock_->raise();
}

QWidget* HelpActions::shown_pane() const {
    return pane_ && dock_->isVisible() ? pane_ : nullptr;
}

void HelpActions::hide() {
    if (dock_) dock_->hide();
}

/// Gives the keyboard to the page, for a user who asked for the page itself; Esc gives it back.
void HelpActions::read() {
    if (!shown_pane()) return;
    before_ = QApplication::focusWidget();
    pane_->setFocus();
}

void HelpActions::show_place(const QString& anchor) {
    if (!pane().has_place(anchor)) return;
    show_dock();  // first: places are found in a text that is laid out
    pane().show_place(anchor);
}

void HelpActions::show_help_on_focus() {
    QString place = help_place(QApplication::focusWidget());
    if (place.isEmpty())
        place = help_anchor(document_.project(), {SetupOwner::analysis, to_std(selection_.analysis())});
    if (!place.isEmpty()) return show_place(place);
    show_keys();
}

void HelpActions::show_keys() {
    pane().show_words(tr("Keys"), keys_text());
    show_dock();
    read();
}

void HelpActions::add_to(QMenu& menu) {
    menu.addAction(icon(QStringLiteral("help")), tr("Help on &What Has the Focus"), QKeySequence(Qt::Key_F1),
                   this, &HelpActions::show_help_on_focus);
    QMenu* models = menu.addMenu(tr("M&odels"));
    for (const ModelDescriptor& model : model_registry())
        models->addAction(core_text(model.title), this, [this, id = model.id] {
            show_place(to_qt("model-" + id));
            read();
        });
    QMenu* assets = menu.addMenu(tr("Artefacts, &Instruments and Robots"));
    for (const AssetDescriptor& asset : asset_registry())
        assets->addAction(core_text(asset.title), this, [this, kind = asset.kind] {
            show_place(to_qt("asset-" + kind));
            read();
        });
    const auto add_page = [&](const QString& title, const char* page) {
        menu.addAction(title, this, [this, page] {
            show_place(QString::fromLatin1(page));
            read();
        });
    };
    add_page(tr("An Everyday &Budget"), "first-steps");
    add_page(tr("&Results and Requirements"), "results");
    add_page(tr("Re&view and Release"), "release");
    add_page(tr("What Every Analysis &Has"), "analysis");
    add_page(tr("The S&cene"), "scene");
    add_page(tr("&Glossary"), "glossary");
    menu.addAction(tr("&Keys"), this, &HelpActions::show_keys);
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("about")), tr("&About Covaria"), this,
                   [this] { show_about(window_); });
}

}  // namespace covaria::ui
