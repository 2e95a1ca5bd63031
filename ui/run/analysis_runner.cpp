// Everything here happens on the owner's thread except the bodies of `prepare` and `execute`.
#include "ui/run/analysis_runner.h"

#include "core/result/result_names.h"
#include "ui/theme/strings.h"

#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <utility>

namespace covaria::ui {

namespace {

using namespace std::chrono_literals;
constexpr auto settling_time = 120ms;  // without a further change, before a live run starts
constexpr std::uint64_t preview_trials = 20'000;
/// A preview is worth its time only before a run that takes much longer.
constexpr std::uint64_t preview_worthwhile = 10 * preview_trials;

bool wants_preview(const EvaluationOptions& options) {
    return options.method == Method::adaptive ||
           (options.method == Method::monte_carlo && options.trials >= preview_worthwhile);
}

PreparedAnalysis preview_of(const PreparedAnalysis& analysis) {
    PreparedAnalysis preview = analysis;
    preview.options.method = Method::monte_carlo;
    preview.options.trials = preview_trials;
    if (preview.options.variance_reduction == VarianceReduction::none)
        preview.options.variance_reduction = VarianceReduction::control_variate;
    preview.options.one_at_a_time_trials = 0;
    preview.options.contributor_trials = 0;
    preview.options.sobol_trials = 0;
    return preview;
}

}  // namespace

AnalysisRunner::AnalysisRunner(QObject* parent)
    : AnalysisRunner(core_backend(), Execution::threads, parent) {}

AnalysisRunner::AnalysisRunner(RunBackend backend, Execution execution, QObject* parent)
    : QObject(parent),
      backend_(std::move(backend)),
      execution_(execution),
      studies_(execution),
      prepare_jobs_(this, execution),
      run_jobs_(this, execution) {
    settling_.setSingleShot(true);
    settling_.setInterval(settling_time);
    connect(&settling_, &QTimer::timeout, this, &AnalysisRunner::start_next);
}

AnalysisRunner::~AnalysisRunner() {
    active_stop_.request_stop();
    run_jobs_.wait();
    prepare_jobs_.wait();
}

void AnalysisRunner::set_project(ProjectSnapshot project) {
    studies_.set_project(project);
    ++preparing_;
    const quint64 number = ++prepare_number_;
    const auto failed = [this, project, generation = generation_](const Error& error) {
        finish_prepare(generation, none_prepared(*project, error));
    };
    prepare_jobs_.push(
        [this, project = std::move(project), live = live_, number, generation = generation_] {
            // Several changes at once: only the newest is worth preparing.
            if (number != prepare_number_) return JobQueue::Delivery([this] { --preparing_; });
            return prepare(*project, live, generation);
        },
        failed);
}

AnalysisRunner::Prepared AnalysisRunner::none_prepared(const Project& project, const Error& error) {
    Prepared prepared;
    for (const AnalysisEntry& entry : project.analyses)
        prepared.analyses[entry.id] = {nullptr, error.message, {}};
    return prepared;
}

void AnalysisRunner::reset(ProjectSnapshot project) {
    stop_all();
    studies_.reset();
    entries_.clear();
    wanted_.clear();
    set_held({});
    ++generation_;
    prepare_jobs_.push(
        [this]() -> JobQueue::Delivery {
            first_order_of_.clear();
            return {};
        },
        {});
    set_project(std::move(project));
}

JobQueue::Delivery AnalysisRunner::prepare(const Project& project, bool live, quint64 generation) {
    auto prepared = std::make_shared<Prepared>();
    prepared->analyses = backend_.prepare(project);
    for (const auto& [id, item] : prepared->analyses) {
        if (!live || !item.analysis || first_order_of_[id] == item.analysis->fingerprint) continue;
        first_order_of_[id] = item.analysis->fingerprint;
        Result<UncertaintyResult> result = backend_.first_order(*item.analysis);
        if (result)
            prepared->first_order[id] = std::make_shared<const UncertaintyResult>(std::move(*result));
        else
            prepared->messages[id] = result.error().message;
    }
    return [this, prepared, generation] { finish_prepare(generation, *prepared); };
}

void AnalysisRunner::finish_prepare(quint64 generation, const Prepared& prepared) {
    --preparing_;
    if (generation != generation_) return;
    std::erase_if(entries_, [&](const auto& entry) { return !prepared.analyses.contains(entry.first); });
    std::erase_if(queue_, [&](const std::string& id) { return !prepared.analyses.contains(id); });
    if (!prepared.analyses.contains(active_id_)) active_stop_.request_stop();
    for (const auto& [id, preparation] : prepared.analyses) {
        update_entry(id, preparation);
        take(id, prepared);
    }
    if (live_ && !queue_.empty() && execution_ == Execution::threads) settling_.start();
    start_wanted();
    start_next();
    announce_idle();
}

void AnalysisRunner::take(const std::string& id, const Prepared& prepared) {
    AnalysisStatus& entry = entries_[id];
    const auto message = prepared.messages.find(id);
    const auto result = prepared.first_order.find(id);
    if (message != prepared.messages.end())
        set_state(id, RunState::failed, message->second);
    else if (result != prepared.first_order.end() && !entry.is_of_present())
        keep(id, entry.prepared, ResultStage::first_order, result->second);
    if (live_ && entry.state == RunState::out_of_date) enqueue(id);
}

void AnalysisRunner::start_wanted() {
    if (preparing_ > 0) return;
    for (const std::string& id : std::exchange(wanted_, {})) run(to_qt(id));
    if (std::exchange(all_wanted_, false)) run_all();
}

void AnalysisRunner::update_entry(const std::string& id, const Preparation& preparation) {
    AnalysisStatus& entry = entries_[id];
    const bool same = entry.prepared && preparation.analysis &&
                      entry.prepared->fingerprint == preparation.analysis->fingerprint;
    entry.prepared = preparation.analysis;
    entry.warnings = preparation.warnings;
    const auto held = held_.find(id);
    entry.held = held == held_.end() ? QString() : held->second;
    if (!preparation.analysis) {
        stop(to_qt(id));
        set_state(id, RunState::failed, preparation.message);
        return;
    }
    if (entry.is_of_present() && entry.result_of != entry.prepared) {
        take_present_names(entry);
        emit result_changed(to_qt(id));
    }
    if (!entry.held.isEmpty()) {
        set_state(id, RunState::failed, to_std(entry.held));
    } else if (!same) {
        if (live_ && active_id_ == id) active_stop_.request_stop();
        set_state(id, resting_state(entry));
    } else {
        emit state_changed(to_qt(id));  // titles and warnings may differ
    }
}

void AnalysisRunner::set_held(const std::map<std::string, QString>& held) {
    if (held == held_) return;
    held_ = held;
    for (auto& [id, entry] : entries_) {
        const auto found = held.find(id);
        const QString reason = found == held.end() ? QString() : found->second;
        if (reason == entry.held) continue;
        entry.held = reason;
        if (!reason.isEmpty()) stop(to_qt(id));
        if (!entry.prepared) continue;  // that is the greater trouble
        set_state(id, reason.isEmpty() ? resting_state(entry) : RunState::failed, to_std(reason));
        if (live_ && entry.state == RunState::out_of_date) enqueue(id);
    }
    start_next();
}

void AnalysisRunner::set_live(bool live) {
    live_ = live;
    if (live) run_all();
}

void AnalysisRunner::run(const QString& id) {
    if (preparing_ > 0) {
        wanted_.insert(id.toStdString());
        return;
    }
    const auto entry = entries_.find(id.toStdString());
    if (entry == entries_.end() || !entry->second.prepared || !entry->second.held.isEmpty()) return;
    if (active_id_ == entry->first) active_stop_.request_stop();
    enqueue(entry->first);
    settling_.stop();
    start_next();
}

void AnalysisRunner::run_all() {
    all_wanted_ = preparing_ > 0;
    if (all_wanted_) return;
    for (const auto& [id, entry] : entries_)
        if (entry.prepared && entry.held.isEmpty() &&
            (entry.state == RunState::out_of_date || entry.state == RunState::failed))
            enqueue(id);
    settling_.stop();
    start_next();
}

void AnalysisRunner::stop(const QString& id) {
    const std::string key = id.toStdString();
    wanted_.erase(key);
    const bool waiting = std::erase(queue_, key) > 0;
    if (active_id_ == key)
        active_stop_.request_stop();
    else if (waiting)
        set_state(key, resting_state(entries_[key]));
    announce_idle();
}

void AnalysisRunner::stop_all() {
    studies_.stop_all();
    wanted_.clear();
    all_wanted_ = false;
    while (!queue_.empty()) stop(to_qt(queue_.front()));
    active_stop_.request_stop();
}

void AnalysisRunner::enqueue(const std::string& id) {
    if (std::find(queue_.begin(), queue_.end(), id) == queue_.end()) queue_.push_back(id);
    set_state(id, RunState::running);
}

void AnalysisRunner::start_next() {
    while (active_number_ == 0 && !queue_.empty() && !settling_.isActive()) {
        auto next = std::find(queue_.begin(), queue_.end(), focus_);
        if (next == queue_.end()) next = queue_.begin();
        const std::string id = *next;
        queue_.erase(next);
        start(id);
    }
}

void AnalysisRunner::start(const std::string& id) {
    const PreparedPointer analysis = entries_[id].prepared;
    const quint64 number = active_number_ = ++run_number_;
    active_id_ = id;
    active_analysis_ = analysis;
    active_stop_ = std::stop_source();
    active_time_.start();
    RunControl control{active_stop_.get_token(), {}, threads_};
    control.progress = [this, number](const Progress& progress) {
        run_jobs_.post([this, number, progress] { report(number, progress); });
    };
    const bool preview =
        live_ && wants_preview(analysis->options) && resting_state(entries_[id]) != RunState::up_to_date;
    run_jobs_.push(
        [this, number, analysis, control, preview]() -> JobQueue::Delivery {
            if (preview && !control.stop.stop_requested()) {
                const RunControl quiet{control.stop, {}, control.threads};
                auto early =
                    std::make_shared<Result<UncertaintyResult>>(backend_.full(preview_of(*analysis), quiet));
                if (*early)
                    run_jobs_.post([=, this] { deliver(number, analysis, ResultStage::preview, early); });
            }
            return execute(number, analysis, control);
        },
        [this, number, analysis](const Error& error) {
            deliver(number, analysis, ResultStage::complete,
                    std::make_shared<Result<UncertaintyResult>>(fail(error)));
            finish_run(number);
        });
}

JobQueue::Delivery AnalysisRunner::execute(quint64 number, const PreparedPointer& analysis,
                                           const RunControl& control) {
    auto result = std::make_shared<Result<UncertaintyResult>>(
        control.stop.stop_requested() ? Result<UncertaintyResult>(fail(ErrorCode::cancelled, {}))
                                      : backend_.full(*analysis, control));
    return [this, number, analysis, result] {
        deliver(number, analysis, ResultStage::complete, result);
        finish_run(number);
    };
}

void AnalysisRunner::deliver(quint64 number, const PreparedPointer& analysis, ResultStage stage,
                             const SharedResult& result) {
    const auto entry = entries_.find(analysis->id);
    if (number != active_number_ || entry == entries_.end()) return;
    if (*result) {
        keep(analysis->id, analysis, stage, ResultPointer(result, &**result));
    } else if (result->error().code != ErrorCode::cancelled && entry->second.prepared &&
               entry->second.prepared->fingerprint == analysis->fingerprint && entry->second.held.isEmpty()) {
        set_state(analysis->id, RunState::failed, result->error().message);
    }
}

void AnalysisRunner::finish_run(quint64 number) {
    if (number != active_number_) return;
    const std::string id = active_id_;
    active_number_ = 0;
    active_id_.clear();
    active_analysis_.reset();
    const auto entry = entries_.find(id);
    const bool waits = std::find(queue_.begin(), queue_.end(), id) != queue_.end();
    if (entry != entries_.end() && !waits && entry->second.state == RunState::running)
        set_state(id, resting_state(entry->second));
    start_next();
    announce_idle();
}

void AnalysisRunner::keep(const std::string& id, const PreparedPointer& analysis, ResultStage stage,
                          ResultPointer result) {
    AnalysisStatus& entry = entries_[id];
    const bool is_newest = entry.prepared && entry.prepared->fingerprint == analysis->fingerprint;
    if (!is_newest && entry.is_of_present()) return;  // never replace a current result by a stale one
    entry.result = std::move(result);
    entry.result_of = analysis;
    entry.stage = stage;
    if (is_newest) take_present_names(entry);
    emit result_changed(to_qt(id));
}

/// Names have no part in the fingerprint: a result stays current when something is renamed.
void AnalysisRunner::take_present_names(AnalysisStatus& entry) {
    if (entry.result_of == entry.prepared) return;
    entry.result_of = entry.prepared;
    if (!entry.prepared->model) return;
    auto renamed = std::make_shared<UncertaintyResult>(*entry.result);
    take_names(*renamed, entry.prepared->model->outputs(), entry.prepared->inputs);
    entry.result = std::move(renamed);
}

void AnalysisRunner::report(quint64 number, const Progress& progress) {
    if (number != active_number_) return;
    const RunProgress shown = progress_after(progress, static_cast<double>(active_time_.elapsed()) / 1000.0);
    emit progress_changed(to_qt(active_id_), shown);
}

RunState AnalysisRunner::resting_state(const AnalysisStatus& status) const {
    return status.is_current() ? RunState::up_to_date : RunState::out_of_date;
}

void AnalysisRunner::set_state(const std::string& id, RunState state, const std::string& message) {
    AnalysisStatus& entry = entries_[id];
    entry.state = state;
    entry.message = to_qt(message);
    emit state_changed(to_qt(id));
}

const AnalysisStatus& AnalysisRunner::status(const QString& id) const {
    static const AnalysisStatus none;
    const auto entry = entries_.find(id.toStdString());
    return entry == entries_.end() ? none : entry->second;
}

void AnalysisRunner::announce_idle() {
    if (!is_busy()) emit idle();
}

bool AnalysisRunner::wait_until_idle(int milliseconds) {
    if (!is_busy()) return true;
    QEventLoop loop;
    QTimer::singleShot(milliseconds, &loop, [&loop] { loop.exit(1); });
    connect(this, &AnalysisRunner::idle, &loop, [&loop] { loop.exit(0); });
    return loop.exec() == 0;
}

}  // namespace covaria::ui
