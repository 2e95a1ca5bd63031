#include "ui/document/project_maker.h"

#include "core/base/counted_problems.h"

namespace covaria::ui {

namespace {

Problems readable_problems(const MadeProject& made) {
    Problems problems = made.problems();
    count_beyond_a_hundred(problems);
    return problems;
}

}  // namespace

ProjectMaker::ProjectMaker(Execution execution, QObject* parent)
    : ProjectMaker(readable_problems, execution, parent) {}

// Live results follow a drag step by step: what has been overtaken is delivered too.
ProjectMaker::ProjectMaker(Check check, Execution execution, QObject* parent)
    : QObject(parent), check_(std::move(check)), job_(execution, LatestJob::Overtaken::delivered) {}

void ProjectMaker::request(ProjectSnapshot project) {
    if (project == requested_) return;
    requested_ = project;
    job_.start(
        [this, project](const std::stop_token&) -> JobQueue::Delivery {
            return [this, outcome = make(project)] { deliver(outcome); };
        },
        [this, project](const Error& error) { fail_to_make(project, error); });
}

void ProjectMaker::make_now(ProjectSnapshot project) {
    job_.cancel();
    requested_ = project;
    deliver(make(std::move(project)));
}

void ProjectMaker::take(MadeProject::Pointer made) {
    requested_ = made->snapshot();
    set_before(made);
    job_.start(
        [this, made](const std::stop_token&) -> JobQueue::Delivery {
            return [this, outcome = Outcome{made, check_(*made)}] { deliver(outcome); };
        },
        [this, made](const Error& error) { fail_to_make(made->snapshot(), error); });
}

void ProjectMaker::forget() {
    job_.cancel();
    set_before(nullptr);
    requested_.reset();
    made_.reset();
    problems_ = {};
    emit forgotten();
}

ProjectMaker::Outcome ProjectMaker::make(ProjectSnapshot project) {
    const auto made = MadeProject::make(std::move(project), before());
    set_before(made);
    return {made, check_(*made)};
}

void ProjectMaker::deliver(Outcome outcome) {
    made_ = std::move(outcome.made);
    problems_ = std::move(outcome.problems);
    emit made_changed();
}

void ProjectMaker::fail_to_make(const ProjectSnapshot& project, const Error& error) {
    requested_.reset();
    emit not_made(project, error);
}

MadeProject::Pointer ProjectMaker::before() const {
    const std::lock_guard lock(mutex_);
    return before_;
}

void ProjectMaker::set_before(MadeProject::Pointer made) {
    const std::lock_guard lock(mutex_);
    before_ = std::move(made);
}

}  // namespace covaria::ui
