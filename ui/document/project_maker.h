// Makes the states of a project in a worker thread, each once and out of the one before.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <mutex>

#include "core/made/made_project.h"
#include "ui/jobs/latest_job.h"

namespace covaria::ui {

using ProjectSnapshot = std::shared_ptr<const Project>;

class ProjectMaker : public QObject {
    Q_OBJECT
public:
    /// Everything that is wrong with a made project; called where it is made.
    using Check = std::function<Problems(const MadeProject&)>;

    explicit ProjectMaker(Execution execution = Execution::threads, QObject* parent = nullptr);
    /// `check`: finds the problems, in place of those of the made project.
    ProjectMaker(Check check, Execution execution, QObject* parent);

    /// Makes the project in a worker. Some states are left out if they follow each other faster, never the
    /// last. The state that was asked for last is not made again.
    void request(ProjectSnapshot project);
    /// Synchronous twin of `request`; emits `made_changed` before it returns.
    void make_now(ProjectSnapshot project);
    /// Takes a project that is made already, and finds only its problems.
    void take(MadeProject::Pointer made);
    /// Stops making and delivering states of the present project: another one is to come.
    void forget();

    /// The newest project that is made; null before the first.
    const MadeProject::Pointer& made() const { return made_; }
    /// Problems of `made()`.
    const Problems& problems() const { return problems_; }
    /// A newer state is being made.
    bool is_making() const { return job_.is_busy(); }

signals:
    void made_changed();
    /// The state that was asked for could not be made: memory that is not there, a defect of the program.
    void not_made(const covaria::ui::ProjectSnapshot& project, const covaria::Error& error);
    /// See `forget`.
    void forgotten();

private:
    struct Outcome {
        MadeProject::Pointer made;
        Problems problems;
    };
    Outcome make(ProjectSnapshot project);
    void deliver(Outcome outcome);
    void fail_to_make(const ProjectSnapshot& project, const Error& error);
    MadeProject::Pointer before() const;
    void set_before(MadeProject::Pointer made);

    Check check_;
    MadeProject::Pointer made_;
    Problems problems_;
    ProjectSnapshot requested_;
    mutable std::mutex mutex_;     ///< guards `before_`
    MadeProject::Pointer before_;  ///< the last that was made, which may not be delivered yet
    LatestJob job_;                ///< last member: its thread ends first
};

}  // namespace covaria::ui
