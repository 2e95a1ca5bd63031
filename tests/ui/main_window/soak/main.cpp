// The real window under random hands: edits of every kind on every example, as fast as they come, with live
// runs between them. It must neither end nor hang nor grow: memory is flat but for the history, which has a
// bound. usage: soak_window EDITS [SEED] [PROJECT ...]     (without projects: all examples)
#include <malloc.h>
#include <unistd.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <fstream>
#include <functional>
#include <random>

#include "ui/main_window/main_window.h"
#include "ui/pages/project_pane.h"
#include "ui/pages/properties_pane.h"
#include "ui/pages/results_pane.h"
#include "ui/theme/fold_groups.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

double resident_mib() {
    std::ifstream statm("/proc/self/statm");
    double total = 0.0, resident = 0.0;
    statm >> total >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

class Hands {
public:
    Hands(MainWindow& window, unsigned seed) : window_(window), random_(seed) {}

    void edit() {
        static const std::vector<std::pair<int, std::function<void(Hands&)>>> ways{
            {30, &Hands::type_into_a_field},
            {10, &Hands::choose_in_a_list},
            {4, &Hands::tick_a_box},
            {14, &Hands::type_into_a_cell},
            {6, &Hands::paste},
            {4, &Hands::add_or_remove_rows},
            {3, &Hands::type_a_line},
            {8, &Hands::undo_or_redo},
            {8, &Hands::show_a_tab},
            {6, &Hands::select_an_entry},
            {2, &Hands::duplicate},
            {2, &Hands::remove},
            {3, &Hands::run_or_stop}};
        int all = 0;
        for (const auto& [weight, way] : ways) all += weight;
        int left = below(all);
        for (const auto& [weight, way] : ways)
            if ((left -= weight) < 0) return way(*this);
    }

private:
    int below(int limit) { return limit < 2 ? 0 : std::uniform_int_distribution<int>(0, limit - 1)(random_); }
    /// One of the widgets of that kind that can be seen and used; null: there is none.
    template <class Widget>
    Widget* any_of(QWidget& area) {
        QList<Widget*> usable;
        for (Widget* widget : area.findChildren<Widget*>())
            if (widget->isVisible() && widget->isEnabled()) usable << widget;
        return usable.isEmpty() ? nullptr : usable[below(int(usable.size()))];
    }
    QString text() {
        static const QStringList texts{"0",    "1",     "-1",   "0.5",    "1e-3",  "12 kg", "abc",  "",
                                       "1e-6", "0.066", "2 mm", "500 um", "3 deg", "1.5",   "1e30", "-7,5"};
        return below(2) ? texts[below(int(texts.size()))] : QString::number(0.001 * below(5000));
    }
    void type(QWidget& into, const QString& words) {
        QTest::keyClicks(&into, words);
        QTest::keyClick(&into, Qt::Key_Return);
    }
    void type_into_a_field() {
        auto* edit = any_of<QLineEdit>(window_.properties());
        if (!edit || edit->isReadOnly()) return;
        edit->setFocus();
        edit->selectAll();
        // A count of trials in the millions would make this a test of the engine.
        type(*edit, edit->objectName().contains(QStringLiteral("trials"), Qt::CaseInsensitive)
                        ? QString::number(100 + below(2000))
                        : text());
    }
    void choose_in_a_list() {
        auto* box = any_of<QComboBox>(window_.properties());
        if (!box) return;
        box->setFocus();
        QTest::keyClick(box, below(2) ? Qt::Key_Down : Qt::Key_Up);
    }
    void tick_a_box() {
        if (auto* box = any_of<QCheckBox>(window_.properties())) box->click();
    }
    QTableView* table_at_a_cell() {
        auto* table = any_of<QTableView>(window_.properties());
        if (!table || !table->model() || table->model()->rowCount() == 0) return nullptr;
        const QModelIndex cell =
            table->model()->index(below(table->model()->rowCount()), below(table->model()->columnCount()));
        table->setFocus();
        table->setCurrentIndex(cell);
        return table;
    }
    void type_into_a_cell() {
        QTableView* table = table_at_a_cell();
        if (!table) return;
        QTest::keyClick(table, Qt::Key_F2);
        QWidget* editor = QApplication::focusWidget();
        if (!editor || editor == table) return;
        if (auto* line = qobject_cast<QLineEdit*>(editor)) line->selectAll();
        type(*editor, text());
    }
    void paste() {
        QTableView* table = table_at_a_cell();
        if (!table) return;
        QGuiApplication::clipboard()->setText(text() + '\t' + text() + '\n' + text() + '\t' + text() + '\n');
        QTest::keySequence(table, QKeySequence::Paste);
    }
    void add_or_remove_rows() {
        QTableView* table = table_at_a_cell();
        if (!table) return;
        const bool more = table->model()->rowCount() < 12 && below(2) == 0;
        QTest::keySequence(table, QKeySequence(Qt::CTRL | (more ? Qt::Key_I : Qt::Key_Minus)));
    }
    void type_a_line() {
        auto* edit = any_of<QPlainTextEdit>(window_.properties());
        if (!edit) return;
        edit->setFocus();
        QTest::keyClicks(edit, below(2) ? QStringLiteral("x") : QStringLiteral(" + 1"));
    }
    void undo_or_redo() {
        QUndoStack& stack = window_.document().undo_stack();
        for (int i = below(6); i >= 0; --i) below(3) ? stack.undo() : stack.redo();
    }
    void show_a_tab() {
        if (FoldGroups& groups = window_.properties().groups(); below(2) && groups.count() > 0)
            return groups.open(below(groups.count()));
        QTabWidget& tabs = window_.results().tabs();
        // The report takes seconds each time; its own tests look at it.
        tabs.setCurrentIndex(below(tabs.count() - 1));
    }
    void select_an_entry() {
        const Project& project = window_.document().project();
        const int assets = int(project.assets.size()), analyses = int(project.analyses.size());
        if (assets + analyses == 0) return;
        const int chosen = below(assets + analyses);
        window_.selection().select_entry(
            chosen < assets
                ? SetupAddress{SetupOwner::asset, project.assets[std::size_t(chosen)].id}
                : SetupAddress{SetupOwner::analysis, project.analyses[std::size_t(chosen - assets)].id});
    }
    void duplicate() {
        const Project& project = window_.document().project();
        if (project.assets.size() + project.analyses.size() < 10)
            window_.project_pane().duplicate_action->trigger();
    }
    void remove() {
        if (window_.document().project().analyses.size() > 1) window_.project_pane().delete_action->trigger();
    }
    void run_or_stop() {
        if (below(2))
            window_.runner().run_all();
        else
            window_.runner().stop_all();
    }

    MainWindow& window_;
    std::mt19937 random_;
};

/// Whether the window shows what the project is: no result counts as current while a text cannot be read.
bool is_truthful(MainWindow& window) {
    const UnreadTexts::Held held = window.document().unread().held(window.document().project());
    for (const auto& [id, reason] : held.analyses)
        if (window.runner().status(to_qt(id)).is_current()) {
            std::printf("the result of %s counts as current while a text cannot be read\n", id.c_str());
            return false;
        }
    return window.document().undo_stack().count() <= window.document().undo_stack().undoLimit();
}

struct Figures {
    double early = 0.0, late = 0.0, bare = 0.0;  ///< bare: without the history of edits
    qint64 longest = 0;
    bool truthful = true;
};

Figures soak(const QString& file, int edits, unsigned seed) {
    QTemporaryDir folder;
    MainWindow window{RecoveryStore(folder.filePath(QStringLiteral("recovery")))};
    Dialogs& dialogs = window.files().dialogs;
    dialogs.save_changes = [](const QString&) { return SaveAnswer::discard; };
    dialogs.confirm = [](const QString&, const QString&) { return true; };
    dialogs.show_message = [](const QString&, const QString&) {};
    dialogs.file_to_save = [](const QString&, const QString&, const QString&) { return QString(); };
    window.resize(1280, 800);
    window.show();
    LoadedProject loaded = load_project(to_path(file));
    for (AnalysisEntry& analysis : loaded.project.analyses) {
        analysis.options.trials = 2000;
        analysis.options.maximum_trials = 20'000;
        analysis.options.contributor_trials = analysis.options.sobol_trials = 0;
        analysis.options.one_at_a_time_trials = 0;
    }
    QSignalSpy opened(&window.document(), &Document::open_finished);
    const QString copy = folder.filePath(QFileInfo(file).fileName());
    loaded.project.directory = to_path(QFileInfo(file).absolutePath());
    window.document().restore({loaded.project, {}, MadeProject::make(loaded.project)}, copy);
    emit window.files().project_opened();
    Hands hands(window, seed);
    Figures figures;
    for (int i = 0; i < edits && figures.truthful; ++i) {
        QElapsedTimer time;
        time.start();
        hands.edit();
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        figures.longest = std::max(figures.longest, time.elapsed());
        if (i % 10 == 9 && !window.runner().wait_until_idle(3000)) window.runner().stop_all();
        figures.truthful = is_truthful(window);
        if (i == edits / 2) figures.early = resident_mib();
    }
    figures.late = resident_mib();
    window.document().undo_stack().clear();
    malloc_trim(0);
    figures.bare = resident_mib();
    window.runner().stop_all();
    window.runner().wait_until_idle(20'000);
    window.close();
    return figures;
}

int soak_all(const QStringList& files, int edits, unsigned seed) {
    std::printf("%-28s %7s %18s %10s %16s %10s\n", "project", "edits", "MiB at the half", "at the end",
                "without history", "longest/ms");
    bool good = true;
    for (const QString& file : files) {
        const Figures figures = soak(file, edits, seed++);
        std::printf("%-28s %7d %18.1f %10.1f %16.1f %10lld\n", qPrintable(QFileInfo(file).completeBaseName()),
                    edits, figures.early, figures.late, figures.bare,
                    static_cast<long long>(figures.longest));
        std::fflush(stdout);
        good = good && figures.truthful;
    }
    return good ? 0 : 1;
}

}  // namespace
}  // namespace covaria::ui

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QTemporaryDir settings;
    QCoreApplication::setOrganizationName(QStringLiteral("CovariaSoak"));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    const QStringList words = QCoreApplication::arguments();
    if (words.size() < 2) return 2;
    QStringList files = words.mid(3);
    if (files.isEmpty())
        for (const char* folder : {"/projects", "/projects/gum"})
            for (const QFileInfo& info : QDir(QStringLiteral(COVARIA_SOURCE_DIR) + QLatin1String(folder))
                                             .entryInfoList({QStringLiteral("*.covaria")}, QDir::Files))
                files << info.filePath();
    return covaria::ui::soak_all(files, words[1].toInt(), words.value(2, QStringLiteral("1")).toUInt());
}
