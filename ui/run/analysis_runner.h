// Runs analyses in worker threads and keeps their results: the latest run wins, stale results are known as
// such.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <set>

#include "ui/document/project_maker.h"
#include "ui/run/inquiries.h"
#include "ui/run/kept_states.h"
#include "ui/run/run_backend.h"
#include "ui/run/run_queue.h"
#include "ui/run/run_state.h"

namespace covaria::ui {

/// Follows the project that a maker makes.
class AnalysisRunner : public QObject {
    Q_OBJECT
public:
    explicit AnalysisRunner(ProjectMaker& maker, QObject* parent = nullptr);
    AnalysisRunner(ProjectMaker& maker, RunBackend backend, Execution execution, QObject* parent = nullptr);
    ~AnalysisRunner() override;

    /// Live: each change gives first-order results at once, then Monte Carlo.
    void set_live(bool live);
    bool is_live() const { return live_; }
    /// The analysis being looked at is computed before the others.
    void set_focus(const QString& id) { runs_.set_focus(id.toStdString()); }
    void set_threads(int threads) {  ///< 0 = as many as the machine has
        runs_.set_threads(threads);
        studies_.set_threads(threads);
        designs_.set_threads(threads);
        kept_.set_threads(threads);
    }
    /// Studies of the same project; they run when asked for.
    StudyRunner& studies() { return studies_; }
    const StudyRunner& studies() const { return studies_; }
    /// Designs of the same project; they run when asked for.
    DesignRunner& designs() { return designs_; }
    const DesignRunner& designs() const { return designs_; }
    /// Results to compare later ones with.
    KeptStates& kept() { return kept_; }
    const KeptStates& kept() const { return kept_; }

    /// Analyses that must not run, with the reason, by id: their results are not current.
    void set_held(const std::map<std::string, QString>& held);

    void run(const QString& id);
    /// Runs all that are not up to date.
    void run_all();
    void stop(const QString& id);
    void stop_all();

    /// Status of an analysis; empty if it does not exist.
    const AnalysisStatus& status(const QString& id) const;
    /// The made project whose analyses these are.
    const MadeProject::Pointer& made() const { return maker_.made(); }
    bool is_busy() const { return is_computing() || kept_.is_busy(); }
    /// Whether the present project is made or evaluated; kept states come after it.
    bool is_computing() const { return maker_.is_making() || first_order_.is_busy() || runs_.is_busy(); }
    /// Waits until nothing is to be done any more, with an event loop of its own. False after `milliseconds`.
    bool wait_until_idle(int milliseconds);

signals:
    void made_changed();  ///< another state of the project; what of it concerns an analysis follows
    void state_changed(const QString& id);
    void result_changed(const QString& id);
    /// Sent some ten times a second at most.
    void progress_changed(const QString& id, const covaria::ui::RunProgress& progress);
    void idle();

private:
    using SharedResult = std::shared_ptr<Result<UncertaintyResult>>;
    using FirstOrder = std::vector<std::pair<PreparedPointer, SharedResult>>;
    void reset();
    void take_made();
    /// Marks all analyses as failed: the project could not be made.
    void take_none(const ProjectSnapshot& project, const Error& error);
    void fail_entry(const std::string& id, const Error& error);
    void update_entry(const std::string& id, const MadeAnalysis& made);
    /// Computes first-order results where there are none; live runs follow.
    void propagate();
    void take_first_order(const FirstOrder& results);
    void start_wanted();
    void enqueue(const std::string& id);
    RunQueue::Run begin_run(const std::string& id);
    void deliver(const PreparedPointer& analysis, ResultStage stage, const SharedResult& result);
    void finish_run(const std::string& id);
    void keep(const std::string& id, const PreparedPointer& analysis, ResultStage stage,
              ResultPointer result);
    void take_present_names(AnalysisStatus& entry);
    void set_state(const std::string& id, RunState state, const Message& message = {});
    RunState resting_state(const AnalysisStatus& status) const;
    void announce_idle();

    ProjectMaker& maker_;
    RunBackend backend_;
    std::map<std::string, AnalysisStatus> entries_;
    std::map<std::string, QString> held_;
    bool live_ = false;
    std::set<std::string> wanted_;  ///< asked for while the project was being made
    bool all_wanted_ = false;
    StudyRunner studies_;
    DesignRunner designs_;
    RunQueue runs_;
    LatestJob first_order_;
    KeptStates kept_;
};

}  // namespace covaria::ui
