// Everything here happens on the owner's thread except the bodies of jobs.
#include "ui/run/study_runner.h"

#include <QEventLoop>
#include <QTimer>
#include <utility>

#include "core/base/guarded.h"
#include "core/project/project_file.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

Result<StudyResult> prepare_and_run(const MadeProject::Pointer& made, const RunKey& key,
                                    const RunControl& control) {
    if (control.stop.stop_requested()) return fail(ErrorCode::cancelled, {});
    Problems problems;
    const auto prepared = prepare_study(made, key.analysis, key.study, problems);
    if (prepared) return run_study(*prepared, control);
    return fail(ErrorCode::bad_input, first_error(problems, "the study cannot be prepared"));
}

const Study* find_study(const Project& project, const RunKey& key) {
    if (const AnalysisEntry* analysis = project.find_analysis(key.analysis))
        for (const Study& study : analysis->studies)
            if (study.id == key.study) return &study;
    return nullptr;
}

std::shared_ptr<const Project> part_of(const Project& project, const RunKey& key) {
    const Study* study = find_study(project, key);
    if (!study) return nullptr;
    return std::make_shared<const Project>(study_part(project, *project.find_analysis(key.analysis), *study));
}

}  // namespace

StudyRunner::StudyRunner(ProjectMaker& maker, Execution execution, QObject* parent)
    : QObject(parent), maker_(maker), runs_([this](const RunKey& key) { return begin_run(key); }, execution) {
    connect(&maker_, &ProjectMaker::forgotten, this, &StudyRunner::reset);
    connect(&maker_, &ProjectMaker::made_changed, this, &StudyRunner::take_made);
    connect(&maker_, &ProjectMaker::not_made, this, &StudyRunner::take_none);
    connect(&runs_, &RunQueue::failed, this, [this](const RunKey& key, const Error& error) {
        if (entries_.contains(key)) set_state(key, RunState::failed, to_qt(error.message));
    });
    connect(&runs_, &RunQueue::idle, this, &StudyRunner::idle);
    connect(&runs_, &RunQueue::progress_changed, this,
            [this](const RunKey& key, const RunProgress& progress) {
                emit progress_changed(name_of(key), progress);
            });
    if (maker_.made()) take_made();
}

void StudyRunner::take_made() {
    const Project& project = maker_.made()->project();
    std::erase_if(entries_, [&](const auto& entry) { return !find_study(project, entry.first); });
    for (const AnalysisEntry& analysis : project.analyses)
        for (const Study& study : analysis.studies) {
            const RunKey key{analysis.id, study.id};
            if (entries_.try_emplace(key).second)
                rest(key);
            else
                compare(key, analysis, study);
        }
    runs_.begin();  // those that waited for this state
}

void StudyRunner::take_none(const ProjectSnapshot&, const Error& error) {
    while (!runs_.waiting().empty()) {
        const RunKey key = runs_.waiting().front();
        runs_.take_out(key);
        set_state(key, RunState::failed, to_qt(error.message));
    }
}

void StudyRunner::compare(const RunKey& key, const AnalysisEntry& analysis, const Study& study) {
    StudyStatus& status = entries_[key];
    if (!status.result && !status.failed_of) return;
    const Project part = study_part(maker_.made()->project(), analysis, study);
    const bool was_current = status.is_current();
    const bool was_failed = status.state == RunState::failed && status.failed_of;
    status.has_same_numbers = status.result && same_numbers(part, *status.result_of);
    const bool other =
        status.is_current() != was_current || (was_failed && !same_numbers(part, *status.failed_of));
    if (other && status.state != RunState::running) rest(key);
}

void StudyRunner::reset() {
    stop_all();
    entries_.clear();
}

void StudyRunner::set_held(const std::map<std::string, QString>& held) {
    const auto before = std::exchange(held_, held);
    for (const auto& [key, entry] : entries_) {
        const auto was = before.find(key.analysis);
        const bool refused = entry.state == RunState::failed && was != before.end() &&
                             entry.message == was->second && !held.contains(key.analysis);
        if (refused) rest(key);
    }
}

void StudyRunner::run(const QString& analysis, const QString& study) {
    const RunKey key{analysis.toStdString(), study.toStdString()};
    if (runs_.waits(key)) return;
    if (const auto held = held_.find(key.analysis); held != held_.end())
        return set_state(key, RunState::failed, held->second);
    runs_.push(key);
    set_state(key, RunState::running);
    runs_.begin();
}

void StudyRunner::stop_all() {
    while (!runs_.waiting().empty()) {
        const RunKey key = runs_.waiting().front();
        runs_.take_out(key);
        set_state(key, RunState::out_of_date);
    }
    runs_.stop_active();
}

RunQueue::Run StudyRunner::begin_run(const RunKey& key) {
    if (maker_.is_making() || !maker_.made()) return {};  // the state to run is still to come
    return [this, key, made = maker_.made()](const RunControl& control) -> JobQueue::Delivery {
        auto ran = guarded([&] { return prepare_and_run(made, key, control); });
        const auto outcome = std::make_shared<const Outcome>(Outcome{
            ran ? *std::move(ran) : Result<StudyResult>(fail(ran.error())), part_of(made->project(), key)});
        return [this, key, outcome] { deliver(key, outcome); };
    };
}

void StudyRunner::deliver(const RunKey& key, const std::shared_ptr<const Outcome>& outcome) {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) return;
    StudyStatus& status = entry->second;
    if (!outcome->result && outcome->result.error().code != ErrorCode::cancelled) {
        set_state(key, RunState::failed, to_qt(outcome->result.error().message));
        status.failed_of = outcome->of;
        return;
    }
    if (outcome->result) {
        status.result = StudyPointer(outcome, &*outcome->result);
        status.result_of = outcome->of;
        const auto now = part_of(maker_.made()->project(), key);
        status.has_same_numbers = now && same_numbers(*now, *status.result_of);
    }
    rest(key);
}

void StudyRunner::rest(const RunKey& key) {
    set_state(key, entries_[key].is_current() ? RunState::up_to_date : RunState::out_of_date);
}

void StudyRunner::set_state(const RunKey& key, RunState state, const QString& message) {
    StudyStatus& entry = entries_[key];
    entry.state = state;
    entry.failed_of.reset();
    entry.message = message;
    emit changed(to_qt(key.analysis), to_qt(key.study));
}

QString StudyRunner::name_of(const RunKey& key) const {
    const Study* study = find_study(maker_.made()->project(), key);
    return to_qt(study && !study->name.empty() ? study->name : key.study);
}

const StudyStatus& StudyRunner::status(const QString& analysis, const QString& study) const {
    static const StudyStatus none;
    const auto entry = entries_.find({analysis.toStdString(), study.toStdString()});
    return entry == entries_.end() ? none : entry->second;
}

bool StudyRunner::wait_until_idle(int milliseconds) {
    if (!is_busy()) return true;
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, [&loop] { loop.exit(1); });
    connect(this, &StudyRunner::idle, &loop, [&loop] { loop.exit(0); });
    return loop.exec() == 0;
}

}  // namespace covaria::ui
