// Runs studies in a worker thread and keeps their results, each known as current or out of date.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>

#include "core/study/study.h"
#include "ui/document/project_maker.h"
#include "ui/run/run_queue.h"
#include "ui/run/run_state.h"

namespace covaria::ui {

using StudyPointer = std::shared_ptr<const StudyResult>;

struct StudyStatus {
    RunState state = RunState::out_of_date;
    QString message = {};                           ///< of a failure
    StudyPointer result = {};                       ///< the newest there is; may be out of date
    std::shared_ptr<const Project> result_of = {};  ///< the part of the project that it was computed from
    bool has_same_numbers = false;                  ///< as that part has now
    std::shared_ptr<const Project> failed_of = {};  ///< likewise, of a failure
    bool is_current() const { return result && has_same_numbers; }
};

/// Follows the project that a maker makes.
class StudyRunner : public QObject {
    Q_OBJECT
public:
    explicit StudyRunner(ProjectMaker& maker, Execution execution, QObject* parent = nullptr);

    void set_threads(int threads) { runs_.set_threads(threads); }
    /// Analyses whose studies must not run, with the reason, by id.
    void set_held(const std::map<std::string, QString>& held);

    void run(const QString& analysis, const QString& study);
    void stop_all();
    const StudyStatus& status(const QString& analysis, const QString& study) const;
    bool is_busy() const { return runs_.is_busy(); }
    /// Waits until no study runs, with an event loop of its own. False after `milliseconds`.
    bool wait_until_idle(int milliseconds);

signals:
    void changed(const QString& analysis, const QString& study);
    /// `name` of the study that runs; some ten times a second at most.
    void progress_changed(const QString& name, const covaria::ui::RunProgress& progress);
    void idle();

private:
    struct Outcome {
        Result<StudyResult> result;
        std::shared_ptr<const Project> of;
    };
    void reset();
    void take_made();
    void take_none(const ProjectSnapshot& project, const Error& error);
    void compare(const RunKey& key, const AnalysisEntry& analysis, const Study& study);
    RunQueue::Run begin_run(const RunKey& key);
    void deliver(const RunKey& key, const std::shared_ptr<const Outcome>& outcome);
    void rest(const RunKey& key);
    void set_state(const RunKey& key, RunState state, const QString& message = {});
    QString name_of(const RunKey& key) const;

    ProjectMaker& maker_;
    std::map<RunKey, StudyStatus> entries_;
    std::map<std::string, QString> held_;
    RunQueue runs_;
};

}  // namespace covaria::ui
