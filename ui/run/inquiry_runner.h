// Runs what an analysis is asked beside its result (studies, designs) in a worker thread and keeps what came
// of it, each known as current or out of date.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ui/document/project_maker.h"
#include "ui/run/run_queue.h"
#include "ui/run/run_state.h"

namespace covaria::ui {

/// A sort of inquiry: one of the lists of an analysis.
struct InquiryKind {
    using Outcome = Result<std::shared_ptr<const void>>;
    std::function<std::vector<std::string>(const AnalysisEntry& analysis)> ids;
    /// The item's name for people; `id` is one of those.
    std::function<std::string(const AnalysisEntry& analysis, const std::string& id)> name;
    /// The part of the project that influences the outcome.
    std::function<Project(const Project& project, const AnalysisEntry& analysis, const std::string& id)> part;
    /// Whether two such parts give the same outcome.
    std::function<bool(const Project& a, const Project& b)> same;
    /// Computes the outcome on a worker thread.
    std::function<Outcome(const MadeProject::Pointer& made, const RunKey& key, const RunControl& control)>
        run;
};

template <class Outcome>
struct InquiryStatus {
    RunState state = RunState::out_of_date;
    QString message = {};                           ///< tells why it failed
    std::shared_ptr<const Outcome> result = {};     ///< the newest there is; may be out of date
    std::shared_ptr<const Project> result_of = {};  ///< the part of the project that it was computed from
    bool has_same_numbers = false;                  ///< `result_of` gives what that part gives now
    std::shared_ptr<const Project> failed_of = {};  ///< the part of the project that a failure came from
    bool is_current() const { return result && has_same_numbers; }
};

/// Follows the project that a maker makes.
class InquiryRunner : public QObject {
    Q_OBJECT
public:
    InquiryRunner(InquiryKind kind, ProjectMaker& maker, Execution execution, QObject* parent = nullptr);

    void set_threads(int threads) { runs_.set_threads(threads); }
    /// Analyses whose inquiries must not run, with the reason, by id.
    void set_held(const std::map<std::string, QString>& held);

    void run(const QString& analysis, const QString& id);
    void stop_all();
    /// Finds out anew what is current: a file that an inquiry reads has changed.
    void recheck();
    bool is_busy() const { return runs_.is_busy(); }
    /// Waits until nothing runs, with an event loop of its own. False after `milliseconds`.
    bool wait_until_idle(int milliseconds);

signals:
    void changed(const QString& analysis, const QString& id);
    /// `name`: of the inquiry that runs; some ten times a second at most.
    void progress_changed(const QString& name, const covaria::ui::RunProgress& progress);
    void idle();

protected:
    using Status = InquiryStatus<void>;
    const Status& status_of(const QString& analysis, const QString& id) const;

private:
    struct Finished {
        InquiryKind::Outcome result;
        std::shared_ptr<const Project> of;
    };
    void reset();
    void take_made();
    void take_none(const ProjectSnapshot& project, const Error& error);
    void compare(const RunKey& key, const AnalysisEntry& analysis);
    bool exists(const Project& project, const RunKey& key) const;
    std::shared_ptr<const Project> part_of(const Project& project, const RunKey& key) const;
    RunQueue::Run begin_run(const RunKey& key);
    void deliver(const RunKey& key, const std::shared_ptr<const Finished>& finished);
    void rest(const RunKey& key);
    void set_state(const RunKey& key, RunState state, const QString& message = {});
    QString name_of(const RunKey& key) const;

    InquiryKind kind_;
    ProjectMaker& maker_;
    std::map<RunKey, Status> entries_;
    std::map<std::string, QString> held_;
    RunQueue runs_;
};

/// A runner whose results have a type.
template <class Outcome>
class InquiriesOf : public InquiryRunner {
public:
    using InquiryRunner::InquiryRunner;
    InquiryStatus<Outcome> status(const QString& analysis, const QString& id) const {
        const Status& known = status_of(analysis, id);
        return {
            known.state,     known.message,          std::static_pointer_cast<const Outcome>(known.result),
            known.result_of, known.has_same_numbers, known.failed_of};
    }
};

}  // namespace covaria::ui
