// Everything here happens on the owner's thread except the bodies of jobs.
#include "ui/run/inquiry_runner.h"

#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/base/guarded.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

InquiryRunner::InquiryRunner(InquiryKind kind, ProjectMaker& maker, Execution execution, QObject* parent)
    : QObject(parent),
      kind_(std::move(kind)),
      maker_(maker),
      runs_([this](const RunKey& key) { return begin_run(key); }, execution) {
    connect(&maker_, &ProjectMaker::forgotten, this, &InquiryRunner::reset);
    connect(&maker_, &ProjectMaker::made_changed, this, &InquiryRunner::take_made);
    connect(&maker_, &ProjectMaker::not_made, this, &InquiryRunner::take_none);
    connect(&runs_, &RunQueue::failed, this, [this](const RunKey& key, const Error& error) {
        if (entries_.contains(key)) set_state(key, RunState::failed, to_qt(error.message));
    });
    connect(&runs_, &RunQueue::idle, this, &InquiryRunner::idle);
    connect(&runs_, &RunQueue::progress_changed, this,
            [this](const RunKey& key, const RunProgress& progress) {
                emit progress_changed(name_of(key), progress);
            });
    if (maker_.made()) take_made();
}

void InquiryRunner::take_made() {
    const Project& project = maker_.made()->project();
    std::erase_if(entries_, [&](const auto& entry) { return !exists(project, entry.first); });
    for (const AnalysisEntry& analysis : project.analyses)
        for (const std::string& id : kind_.ids(analysis)) {
            const RunKey key{analysis.id, id};
            if (entries_.try_emplace(key).second)
                rest(key);
            else
                compare(key, analysis);
        }
    runs_.begin();  // the ones that waited for this state
}

void InquiryRunner::recheck() {
    if (maker_.made()) take_made();
}

void InquiryRunner::take_none(const ProjectSnapshot&, const Error& error) {
    while (!runs_.waiting().empty()) {
        const RunKey key = runs_.waiting().front();
        runs_.take_out(key);
        set_state(key, RunState::failed, to_qt(error.message));
    }
}

void InquiryRunner::compare(const RunKey& key, const AnalysisEntry& analysis) {
    Status& status = entries_[key];
    if (!status.result && !status.failed_of) return;
    const Project part = kind_.part(maker_.made()->project(), analysis, key.inquiry);
    const bool was_current = status.is_current();
    const bool was_failed = status.state == RunState::failed && status.failed_of;
    status.has_same_numbers = status.result && kind_.same(part, *status.result_of);
    const bool other =
        status.is_current() != was_current || (was_failed && !kind_.same(part, *status.failed_of));
    if (other && status.state != RunState::running) rest(key);
}

void InquiryRunner::reset() {
    stop_all();
    entries_.clear();
}

void InquiryRunner::set_held(const std::map<std::string, QString>& held) {
    const auto before = std::exchange(held_, held);
    for (const auto& [key, entry] : entries_) {
        const auto was = before.find(key.analysis);
        const bool refused = entry.state == RunState::failed && was != before.end() &&
                             entry.message == was->second && !held.contains(key.analysis);
        if (refused) rest(key);
    }
}

void InquiryRunner::run(const QString& analysis, const QString& id) {
    const RunKey key{analysis.toStdString(), id.toStdString()};
    if (runs_.waits(key)) return;
    if (const auto held = held_.find(key.analysis); held != held_.end())
        return set_state(key, RunState::failed, held->second);
    runs_.push(key);
    set_state(key, RunState::running);
    runs_.begin();
}

void InquiryRunner::stop_all() {
    while (!runs_.waiting().empty()) {
        const RunKey key = runs_.waiting().front();
        runs_.take_out(key);
        set_state(key, RunState::out_of_date);
    }
    runs_.stop_active();
}

RunQueue::Run InquiryRunner::begin_run(const RunKey& key) {
    if (maker_.is_making() || !maker_.made()) return {};  // the state to run is still to come
    return [this, key, made = maker_.made()](const RunControl& control) -> JobQueue::Delivery {
        const auto of = part_of(made->project(), key);  // files in it are as they are before they are read
        auto ran = guarded([&] { return kind_.run(made, key, control); });
        const auto finished = std::make_shared<const Finished>(
            Finished{ran ? *std::move(ran) : InquiryKind::Outcome(fail(ran.error())), of});
        return [this, key, finished] { deliver(key, finished); };
    };
}

void InquiryRunner::deliver(const RunKey& key, const std::shared_ptr<const Finished>& finished) {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) return;
    Status& status = entry->second;
    if (!finished->result && finished->result.error().code != ErrorCode::cancelled) {
        set_state(key, RunState::failed, to_qt(finished->result.error().message));
        status.failed_of = finished->of;
        return;
    }
    if (finished->result) {
        status.result = *finished->result;
        status.result_of = finished->of;
        const auto now = part_of(maker_.made()->project(), key);
        status.has_same_numbers = now && kind_.same(*now, *status.result_of);
    }
    rest(key);
}

void InquiryRunner::rest(const RunKey& key) {
    set_state(key, entries_[key].is_current() ? RunState::up_to_date : RunState::out_of_date);
}

void InquiryRunner::set_state(const RunKey& key, RunState state, const QString& message) {
    Status& entry = entries_[key];
    entry.state = state;
    entry.failed_of.reset();
    entry.message = message;
    emit changed(to_qt(key.analysis), to_qt(key.inquiry));
}

bool InquiryRunner::exists(const Project& project, const RunKey& key) const {
    const AnalysisEntry* analysis = project.find_analysis(key.analysis);
    return analysis && std::ranges::count(kind_.ids(*analysis), key.inquiry) > 0;
}

std::shared_ptr<const Project> InquiryRunner::part_of(const Project& project, const RunKey& key) const {
    if (!exists(project, key)) return nullptr;
    return std::make_shared<const Project>(
        kind_.part(project, *project.find_analysis(key.analysis), key.inquiry));
}

QString InquiryRunner::name_of(const RunKey& key) const {
    const Project& project = maker_.made()->project();
    const std::string name =
        exists(project, key) ? kind_.name(*project.find_analysis(key.analysis), key.inquiry) : "";
    return to_qt(name.empty() ? key.inquiry : name);
}

const InquiryRunner::Status& InquiryRunner::status_of(const QString& analysis, const QString& id) const {
    static const Status none;
    const auto entry = entries_.find({analysis.toStdString(), id.toStdString()});
    return entry == entries_.end() ? none : entry->second;
}

bool InquiryRunner::wait_until_idle(int milliseconds) {
    if (!is_busy()) return true;
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, [&loop] { loop.exit(1); });
    connect(this, &InquiryRunner::idle, &loop, [&loop] { loop.exit(0); });
    return loop.exec() == 0;
}

}  // namespace covaria::ui
