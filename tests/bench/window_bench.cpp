// Times that a user waits for in the window, as a table: start, a live edit, turning the scene, dragging an
// instrument, memory. Run by hand; the goals are those of docs/performance.md.
// usage: window_bench [start|edit|turn|drag|large|memory ...]
#include <unistd.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

#include "core/project/project_file.h"
#include "tests/bench/large_network.h"
#include "tests/viz/stewart_scene.h"
#include "ui/main_window/main_window.h"
#include "ui/pages/properties_pane.h"
#include "ui/scene_view/scene_panel.h"

namespace covaria::ui {
namespace {

const QString project_file = QStringLiteral(COVARIA_SOURCE_DIR "/projects/stewart-platform.covaria");
const QString network_file = QStringLiteral(COVARIA_SOURCE_DIR "/projects/lsm-network.covaria");

void row(const char* what, double value, const char* unit, const char* goal) {
    std::printf("%-58s %9.1f %-8s %s\n", what, value, unit, goal);
    std::fflush(stdout);
}

/// Since the kernel started this process, s.
double age_of_process() {
    std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
    std::string text((std::istreambuf_iterator<char>(stat)), {});
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    std::string field;
    for (int i = 3; i <= 22; ++i) fields >> field;  // 22: start time in clock ticks
    double now = 0.0;
    uptime >> now;
    return now - std::stod(field) / double(sysconf(_SC_CLK_TCK));
}

double resident_mib() {
    std::ifstream statm("/proc/self/statm");
    double total = 0.0, resident = 0.0;
    statm >> total >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct OpenWindow {
    explicit OpenWindow(const QString& file = project_file) : window(RecoveryStore(folder.path())) {
        window.files().dialogs.save_changes = [](const QString&) { return SaveAnswer::discard; };
        window.show();
        window.begin(file);
    }
    ~OpenWindow() { window.close(); }
    /// Forms filled, first-order results and a picture of the scene there.
    bool is_usable() {
        const AnalysisStatus& status = window.runner().status(window.selection().analysis());
        return field() && field()->isVisible() && status.result && !window.scene().view().image().isNull();
    }
    QLineEdit* field() { return window.properties().findChild<QLineEdit*>(QStringLiteral("base_u_x")); }
    const AnalysisStatus& status() { return window.runner().status(window.selection().analysis()); }
    void wait_usable() {
        while (!is_usable()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    /// Edits by the keyboard; returns when results are shown: the law of propagation's (which come first), or
    /// those of trials, ms.
    double live_edit(int i, bool trials = false) {
        QLineEdit* edit = field();
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QString::number(0.07 + 1e-5 * i) + QStringLiteral(" mm"));
        const PreparedPointer before = status().result_of;
        bool shown = false;
        const auto connection =
            QObject::connect(&window.runner(), &AnalysisRunner::result_changed, &window, [&] {
                const bool wanted = !trials || (status().result && status().result->trials > 0);
                shown = shown || (wanted && status().is_of_present() && status().result_of != before);
            });
        QElapsedTimer clock;
        clock.start();
        QTest::keyClick(edit, Qt::Key_Return);
        while (!shown) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        window.repaint();  // the result's views have changed; now they are painted
        const double ms = double(clock.nsecsElapsed()) * 1e-6;
        QObject::disconnect(connection);
        return ms;
    }

    QTemporaryDir folder;
    MainWindow window;
};

void measure_start() {
    OpenWindow open;
    open.wait_usable();
    open.window.repaint();
    row("start: process to usable window with results and scene", 1000.0 * age_of_process(), "ms",
        "goal 1500");
}

void measure_edits() {
    OpenWindow open;
    open.wait_usable();
    open.window.runner().wait_until_idle(60'000);
    std::vector<double> idle, busy, trials;
    for (int i = 100; i < 120; ++i) {
        trials.push_back(open.live_edit(i, true));
        open.window.runner().wait_until_idle(60'000);
        QTest::qWait(300);
    }
    for (int i = 0; i < 20; ++i) {
        idle.push_back(open.live_edit(i));
        open.window.runner().wait_until_idle(60'000);
        QTest::qWait(300);
    }
    for (int i = 20; i < 60; ++i) {
        busy.push_back(open.live_edit(i));
        QTest::qWait(100);
    }
    row("live edit: Enter to first-order results, 13 poses, median", median(idle), "ms", "goal 50");
    row("live edit: the slowest of 20", *std::max_element(idle.begin(), idle.end()), "ms", "");
    row("live edit: Enter to Monte Carlo values of 13 poses, median", median(trials), "ms", "goal 100");
    row("live edit: median while Monte Carlo still runs", median(busy), "ms", "goal 50");
}

void measure_turning() {
    SceneView view;
    view.resize(1280, 800);
    view.show();
    view.show_scene(std::make_shared<const Scene>(build_scene(test::stewart_setup(14'286).source(), {})));
    view.service().wait_until_idle();
    int pictures = 0;
    QObject::connect(&view.service(), &RenderService::rendered, &view, [&] { ++pictures; });
    QElapsedTimer clock;
    clock.start();
    QPoint at(400, 400);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    for (int i = 0; clock.elapsed() < 5000; ++i) {
        at.rx() += i % 200 < 100 ? 5 : -5;
        QTest::mouseMove(&view, at);
        QCoreApplication::processEvents();
        QTest::qSleep(4);  // a mouse reports some 125 to 250 times a second
    }
    const double seconds = double(clock.elapsed()) / 1000.0;
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    row("turning 1e5 trials at 1280 x 800: pictures a second", pictures / seconds, "1/s", "goal 20");
}

/// Measures how often in a second ellipsoids follow while an instrument of the network is dragged.
void measure_dragging() {
    OpenWindow open(network_file);
    const auto busy = [&] { return !open.status().result || open.window.scene().view().image().isNull(); };
    while (busy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    open.window.runner().wait_until_idle(60'000);
    SceneView& view = open.window.scene().view();
    view.set_view(StandardView::top);
    QTest::qWait(500);
    const std::string id = "body:C2";
    const SceneItem* item = find_item(*view.scene(), id);
    if (!item) return row("dragging a sensor: it is not in the scene", 0.0, "", "");
    Pixel pixel;
    view.service().post([&](SceneRenderer& renderer) { pixel = renderer.project(item->position); });
    view.service().wait_until_idle();
    view.select(QString::fromStdString(id));
    int results = 0, places = 0;
    Eigen::Vector3d place = item->position;
    QObject::connect(&open.window.runner(), &AnalysisRunner::result_changed, &view,
                     [&] { results += open.status().is_of_present() ? 1 : 0; });
    QObject::connect(&view.service(), &RenderService::rendered, &view, [&] {
        const SceneItem* now = view.scene() ? find_item(*view.scene(), id) : nullptr;
        if (!now || now->position == place || view.scene()->ellipsoids.empty()) return;
        place = now->position;
        ++places;
    });
    QPoint at = (QPointF(pixel.x, pixel.y) / view.devicePixelRatioF()).toPoint();
    QElapsedTimer clock;
    clock.start();
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    for (int i = 0; clock.elapsed() < 5000; ++i) {
        at.rx() += i % 60 < 30 ? 1 : -1;
        QTest::mouseMove(&view, at);
        QCoreApplication::processEvents();
        QTest::qSleep(4);
    }
    const double seconds = double(clock.elapsed()) / 1000.0;
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    row("dragging a sensor: first-order results a second", results / seconds, "1/s", "goal 20");
    row("dragging a sensor: pictures of new places with ellipsoids", places / seconds, "1/s", "goal 20");
}

/// 30 instruments and 1,000 targets: opening, and how long the window is busy with an edit.
void measure_large() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("large.covaria"));
    Project large = bench::large_network(30, 1000);
    large.analyses[0].options.method = Method::first_order;
    if (!save_project(large, file.toStdString())) return;
    QElapsedTimer clock;
    clock.start();
    OpenWindow open(file);
    const auto wait_for_result = [&](const PreparedPointer& before) {
        qint64 longest = 0, last = clock.elapsed();
        while (!open.status().result || !open.status().is_of_present() || open.status().result_of == before) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
            longest = std::max(longest, clock.elapsed() - last);
            last = clock.elapsed();
        }
        return longest;
    };
    wait_for_result(nullptr);
    row("30 x 1,000: from opening to first-order results", double(clock.elapsed()), "ms", "goal: seconds");
    open.window.runner().wait_until_idle(120'000);
    open.window.grab().save(folder.filePath(QStringLiteral("w.png")));
    const PreparedPointer before = open.status().result_of;
    clock.restart();
    open.window.document().apply(QStringLiteral("Move"), [](Project& project) {
        auto& rows = std::get<SetupTable>(project.analyses[0].setup.values.at("targets")).rows;
        std::get<double>(rows[500][1]) += 10.0;
    });
    const auto blocked = double(wait_for_result(before));
    row("30 x 1,000: an edit to first-order results", double(clock.elapsed()), "ms", "goal: seconds");
    row("30 x 1,000: longest time without an answer to the mouse", blocked, "ms", "goal 500");
    row("30 x 1,000: resident memory", resident_mib(), "MiB", "");
    if (qEnvironmentVariableIsSet("COVARIA_BENCH_PICTURE"))
        open.window.grab().save(qEnvironmentVariable("COVARIA_BENCH_PICTURE"));
}

void measure_memory() {
    OpenWindow open;
    open.wait_usable();
    open.window.runner().wait_until_idle(60'000);
    const auto edits = [&](int from, int to) {
        for (int i = from; i < to; ++i) {
            open.live_edit(i);
            open.window.document().end_merging();
        }
        open.window.runner().wait_until_idle(60'000);
    };
    edits(0, 100);
    const double early = resident_mib();
    edits(100, 1100);
    row("memory: resident after 100 live edits", early, "MiB", "");
    row("memory: growth over 1000 more", resident_mib() - early, "MiB", "goal: flat");
}

}  // namespace

int run(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("CovariaBench"));
    QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    const QStringList wanted = QApplication::arguments().mid(1);
    const auto wants = [&](const char* name) {
        return wanted.isEmpty() || wanted.contains(QString::fromLatin1(name));
    };
    if (wants("start")) measure_start();
    if (wants("edit")) measure_edits();
    if (wants("turn")) measure_turning();
    if (wants("drag")) measure_dragging();
    if (wants("large")) measure_large();
    if (wants("memory")) measure_memory();
    return 0;
}

}  // namespace covaria::ui

int main(int argc, char** argv) {
    return covaria::ui::run(argc, argv);
}
