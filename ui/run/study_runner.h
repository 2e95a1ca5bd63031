// Runs studies in a worker thread and keeps their results, each known as current or out of date.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <stop_token>

#include "core/study/study.h"
#include "ui/run/job_queue.h"
#include "ui/run/run_state.h"

namespace covaria::ui {

using StudyPointer = std::shared_ptr<const StudyResult>;

struct StudyStatus {
    RunState state = RunState::out_of_date;
    QString message = {};          ///< of a failure
    StudyPointer result = {};      ///< the newest there is; may be out of date
    std::string fingerprint = {};  ///< of the study as it is now
    bool is_current() const { return result && result->fingerprint == fingerprint; }
};

class StudyRunner : public QObject {
    Q_OBJECT
public:
    explicit StudyRunner(Execution execution, QObject* parent = nullptr);
    ~StudyRunner() override;

    /// The project as it is now; which results are still current is found out in a worker thread.
    void set_project(ProjectSnapshot project);
    void reset();  ///< another project: all results are forgotten
    void set_threads(int threads) { threads_ = threads; }

    /// Analyses whose studies must not run, with the reason, by id.
    void set_held(const std::map<std::string, QString>& held);

    void run(const QString& analysis, const QString& study);
    void stop_all();
    const StudyStatus& status(const QString& analysis, const QString& study) const;
    bool is_busy() const { return active_number_ != 0 || !queue_.empty(); }
    /// Waits until no study runs, with an event loop of its own. False after `milliseconds`.
    bool wait_until_idle(int milliseconds);

signals:
    void changed(const QString& analysis, const QString& study);
    /// `name` of the study that runs; some ten times a second at most.
    void progress_changed(const QString& name, const covaria::ui::RunProgress& progress);
    void idle();

private:
    using Key = std::pair<std::string, std::string>;
    using SharedResult = std::shared_ptr<Result<StudyResult>>;
    void take_fingerprints(const std::map<Key, std::string>& fingerprints);
    void start_next();
    void deliver(quint64 number, const Key& key, const SharedResult& result);
    void set_state(const Key& key, RunState state, const QString& message = {});

    std::map<Key, StudyStatus> entries_;
    std::map<std::string, QString> held_;
    ProjectSnapshot project_ = std::make_shared<const Project>();
    std::deque<Key> queue_;
    int threads_ = 0;
    std::atomic<quint64> project_number_ = 0;
    quint64 run_number_ = 0;
    quint64 active_number_ = 0;  ///< 0: none runs
    std::stop_source active_stop_;
    QElapsedTimer active_time_;
    JobQueue check_jobs_;
    JobQueue run_jobs_;
};

}  // namespace covaria::ui
