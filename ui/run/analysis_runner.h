// Runs analyses in worker threads and keeps their results: the latest run wins, stale results are known as
// such.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <deque>
#include <map>
#include <set>
#include <stop_token>

#include "ui/run/job_queue.h"
#include "ui/run/run_backend.h"
#include "ui/run/run_state.h"
#include "ui/run/study_runner.h"

namespace covaria::ui {

class AnalysisRunner : public QObject {
    Q_OBJECT
public:
    explicit AnalysisRunner(QObject* parent = nullptr);
    AnalysisRunner(RunBackend backend, Execution execution, QObject* parent = nullptr);
    ~AnalysisRunner() override;

    /// The project as it is now; call it after every change. Preparing happens in a worker thread.
    void set_project(ProjectSnapshot project);
    /// Another project: all results are forgotten.
    void reset(ProjectSnapshot project);

    /// Live: after each change first-order results at once, then Monte Carlo.
    void set_live(bool live);
    bool is_live() const { return live_; }
    /// The analysis being looked at is computed before the others.
    void set_focus(const QString& id) { focus_ = id.toStdString(); }
    void set_threads(int threads) {  ///< 0 = as many as the machine has
        threads_ = threads;
        studies_.set_threads(threads);
    }
    /// Studies of the same project; they run when asked for.
    StudyRunner& studies() { return studies_; }
    const StudyRunner& studies() const { return studies_; }

    /// Analyses that must not run, with the reason, by id: their results are not current.
    void set_held(const std::map<std::string, QString>& held);

    void run(const QString& id);
    /// All that are not up to date.
    void run_all();
    void stop(const QString& id);
    void stop_all();

    /// Of an analysis that does not exist: an empty status.
    const AnalysisStatus& status(const QString& id) const;
    bool is_busy() const { return preparing_ > 0 || active_number_ != 0 || !queue_.empty(); }
    /// Waits until nothing is to be done any more, with an event loop of its own. False after `milliseconds`.
    bool wait_until_idle(int milliseconds);

signals:
    void state_changed(const QString& id);
    void result_changed(const QString& id);
    /// Some ten times a second at most.
    void progress_changed(const QString& id, const covaria::ui::RunProgress& progress);
    void idle();

private:
    struct Prepared {
        std::map<std::string, Preparation> analyses;
        std::map<std::string, ResultPointer> first_order;
        std::map<std::string, std::string> messages;  ///< of first-order failures
    };
    using SharedResult = std::shared_ptr<Result<UncertaintyResult>>;
    /// Every analysis of the project as one that cannot be prepared.
    static Prepared none_prepared(const Project& project, const Error& error);
    JobQueue::Delivery prepare(const Project& project, bool live, quint64 generation);
    void finish_prepare(quint64 generation, const Prepared& prepared);
    void take(const std::string& id, const Prepared& prepared);
    void start_wanted();
    void update_entry(const std::string& id, const Preparation& preparation);
    void enqueue(const std::string& id);
    void start_next();
    void start(const std::string& id);
    JobQueue::Delivery execute(quint64 number, const PreparedPointer& analysis, const RunControl& control);
    void deliver(quint64 number, const PreparedPointer& analysis, ResultStage stage,
                 const SharedResult& result);
    void finish_run(quint64 number);
    void report(quint64 number, const Progress& progress);
    void keep(const std::string& id, const PreparedPointer& analysis, ResultStage stage,
              ResultPointer result);
    void take_present_names(AnalysisStatus& entry);
    void set_state(const std::string& id, RunState state, const std::string& message = {});
    RunState resting_state(const AnalysisStatus& status) const;
    void announce_idle();

    RunBackend backend_;
    std::map<std::string, AnalysisStatus> entries_;
    std::deque<std::string> queue_;  ///< waiting for the run thread
    std::map<std::string, QString> held_;
    std::string focus_;
    bool live_ = false;
    int threads_ = 0;

    int preparing_ = 0;  ///< jobs not delivered yet
    std::atomic<quint64> prepare_number_ = 0;
    quint64 generation_ = 0;                             ///< of projects: `reset` begins another
    std::map<std::string, std::string> first_order_of_;  ///< fingerprints; used by preparing jobs only
    std::set<std::string> wanted_;                       ///< asked for while the project was being prepared
    bool all_wanted_ = false;
    quint64 run_number_ = 0;
    quint64 active_number_ = 0;  ///< 0: no run
    std::string active_id_;
    PreparedPointer active_analysis_;
    std::stop_source active_stop_;
    QElapsedTimer active_time_;
    /// While changes follow each other closely (typing, dragging), live runs wait: the law of propagation has
    /// the processor to itself.
    QTimer settling_;
    Execution execution_;

    StudyRunner studies_;
    JobQueue prepare_jobs_;
    JobQueue run_jobs_;
};

}  // namespace covaria::ui
