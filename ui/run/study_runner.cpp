// Everything here happens on the owner's thread except the bodies of jobs.
#include "ui/run/study_runner.h"

#include "ui/theme/strings.h"

#include <QEventLoop>
#include <QTimer>
#include <algorithm>

namespace covaria::ui {

namespace {

Result<StudyResult> prepare_and_run(const Project& project, const std::string& analysis,
                                    const std::string& study, const RunControl& control) {
    if (control.stop.stop_requested()) return fail(ErrorCode::cancelled, {});
    Problems of_assets, problems;
    const AssetLibrary assets = make_assets(project, of_assets);
    const auto prepared = prepare_study(project, analysis, study, assets, problems);
    if (prepared) return run_study(*prepared, control);
    for (const Problem& problem : problems.items())
        if (problem.severity == Severity::error) return fail(ErrorCode::bad_input, problem.message);
    return fail(ErrorCode::bad_input, "the study cannot be prepared");
}

}  // namespace

StudyRunner::StudyRunner(Execution execution, QObject* parent)
    : QObject(parent), check_jobs_(this, execution), run_jobs_(this, execution) {}

StudyRunner::~StudyRunner() {
    active_stop_.request_stop();
    run_jobs_.wait();
    check_jobs_.wait();
}

void StudyRunner::set_project(ProjectSnapshot project) {
    project_ = std::move(project);
    const bool any = std::any_of(project_->analyses.begin(), project_->analyses.end(),
                                 [](const AnalysisEntry& entry) { return !entry.studies.empty(); });
    if (!any && entries_.empty()) return;
    check_jobs_.push(
        [this, project = project_, number = ++project_number_]() -> JobQueue::Delivery {
            if (number != project_number_) return {};  // a newer project is waiting
            std::map<Key, std::string> fingerprints;
            for (const AnalysisEntry& entry : project->analyses)
                for (const Study& study : entry.studies)
                    fingerprints[{entry.id, study.id}] = study_fingerprint(*project, entry, study);
            return [this, number, fingerprints = std::move(fingerprints)] {
                if (number == project_number_) take_fingerprints(fingerprints);
            };
        },
        [this](const Error&) { take_fingerprints({}); });  // what cannot be compared is not current
}

void StudyRunner::take_fingerprints(const std::map<Key, std::string>& fingerprints) {
    std::erase_if(entries_, [&](const auto& entry) { return !fingerprints.contains(entry.first); });
    for (const auto& [key, fingerprint] : fingerprints) {
        StudyStatus& entry = entries_[key];
        const bool same = entry.fingerprint == fingerprint;
        entry.fingerprint = fingerprint;
        if (same || entry.state == RunState::running) continue;
        set_state(key, entry.is_current() ? RunState::up_to_date : RunState::out_of_date);
    }
}

void StudyRunner::reset() {
    stop_all();
    entries_.clear();
    ++project_number_;
}

void StudyRunner::set_held(const std::map<std::string, QString>& held) {
    const auto before = std::exchange(held_, held);
    for (const auto& [key, entry] : entries_) {
        const auto was = before.find(key.first);
        const bool refused = entry.state == RunState::failed && was != before.end() &&
                             entry.message == was->second && !held.contains(key.first);
        if (refused) set_state(key, entry.is_current() ? RunState::up_to_date : RunState::out_of_date);
    }
}

void StudyRunner::run(const QString& analysis, const QString& study) {
    const Key key{analysis.toStdString(), study.toStdString()};
    if (std::find(queue_.begin(), queue_.end(), key) != queue_.end()) return;
    if (const auto held = held_.find(key.first); held != held_.end())
        return set_state(key, RunState::failed, held->second);
    queue_.push_back(key);
    set_state(key, RunState::running);
    start_next();
}

void StudyRunner::stop_all() {
    for (const Key& key : std::exchange(queue_, {})) set_state(key, RunState::out_of_date);
    active_stop_.request_stop();
}

void StudyRunner::start_next() {
    if (active_number_ != 0 || queue_.empty()) return;
    const Key key = queue_.front();
    queue_.pop_front();
    const quint64 number = active_number_ = ++run_number_;
    active_stop_ = std::stop_source();
    active_time_.start();
    QString name = to_qt(key.second);
    if (const AnalysisEntry* analysis = project_->find_analysis(key.first))
        for (const Study& study : analysis->studies)
            if (study.id == key.second && !study.name.empty()) name = to_qt(study.name);
    RunControl control{active_stop_.get_token(), {}, threads_};
    control.progress = [this, number, name](const Progress& progress) {
        run_jobs_.post([this, number, name, progress] {
            if (number != active_number_) return;
            emit progress_changed(
                name, progress_after(progress, static_cast<double>(active_time_.elapsed()) / 1000.0));
        });
    };
    run_jobs_.push(
        [this, number, key, control, project = project_]() -> JobQueue::Delivery {
            auto result = std::make_shared<Result<StudyResult>>(
                prepare_and_run(*project, key.first, key.second, control));
            return [this, number, key, result] { deliver(number, key, result); };
        },
        [this, number, key](const Error& error) {
            deliver(number, key, std::make_shared<Result<StudyResult>>(fail(error)));
        });
}

void StudyRunner::deliver(quint64 number, const Key& key, const SharedResult& result) {
    if (number != active_number_) return;
    active_number_ = 0;
    const auto entry = entries_.find(key);
    if (entry != entries_.end()) {
        StudyStatus& status = entry->second;
        if (*result) {
            status.result = StudyPointer(result, &**result);
            set_state(key, status.is_current() ? RunState::up_to_date : RunState::out_of_date);
        } else if (result->error().code == ErrorCode::cancelled) {
            set_state(key, status.is_current() ? RunState::up_to_date : RunState::out_of_date);
        } else {
            set_state(key, RunState::failed, to_qt(result->error().message));
        }
    }
    start_next();
    if (!is_busy()) emit idle();
}

void StudyRunner::set_state(const Key& key, RunState state, const QString& message) {
    StudyStatus& entry = entries_[key];
    entry.state = state;
    entry.message = message;
    emit changed(to_qt(key.first), to_qt(key.second));
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
