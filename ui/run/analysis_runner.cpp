// Everything here happens on the owner's thread except the bodies of jobs.
#include "ui/run/analysis_runner.h"

#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "core/result/result_names.h"
#include "ui/document/missing_fields.h"
#include "ui/document/setup_address.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

/// Twelve batches: with a control variate worth millions of plain trials.
constexpr std::uint64_t preview_trials = 12'000;
/// A preview is worth its time only before a run that takes much longer.
constexpr std::uint64_t preview_worthwhile = 200'000;

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

void compare(AnalysisStatus& entry) {
    entry.has_same_numbers =
        entry.prepared && entry.result_of && same_numbers(*entry.prepared, *entry.result_of);
}

}  // namespace

AnalysisRunner::AnalysisRunner(ProjectMaker& maker, QObject* parent)
    : AnalysisRunner(maker, core_backend(), Execution::threads, parent) {}

AnalysisRunner::AnalysisRunner(ProjectMaker& maker, RunBackend backend, Execution execution, QObject* parent)
    : QObject(parent),
      maker_(maker),
      backend_(std::move(backend)),
      studies_(study_inquiries(), maker, execution),
      designs_(design_inquiries(), maker, execution),
      runs_([this](const RunKey& key) { return begin_run(key.analysis); }, execution),
      first_order_(execution, LatestJob::Overtaken::delivered),
      kept_(*this, backend_, execution) {
    connect(&maker_, &ProjectMaker::forgotten, this, &AnalysisRunner::reset);
    connect(&maker_, &ProjectMaker::made_changed, this, &AnalysisRunner::take_made);
    connect(&maker_, &ProjectMaker::not_made, this, &AnalysisRunner::take_none);
    connect(&runs_, &RunQueue::failed, this, [this](const RunKey& key, const Error& error) {
        if (!runs_.waits(key)) fail_entry(key.analysis, error);
    });
    connect(&runs_, &RunQueue::ended, this, [this](const RunKey& key) { finish_run(key.analysis); });
    connect(&runs_, &RunQueue::idle, this, &AnalysisRunner::announce_idle);
    connect(&runs_, &RunQueue::progress_changed, this,
            [this](const RunKey& key, const RunProgress& progress) {
                emit progress_changed(to_qt(key.analysis), progress);
            });
    connect(this, &AnalysisRunner::result_changed, &kept_, &KeptStates::want);
    connect(&kept_, &KeptStates::idle, this, &AnalysisRunner::announce_idle);
    if (maker_.made()) take_made();
}

AnalysisRunner::~AnalysisRunner() = default;

/// Forgets all results: there is another project.
void AnalysisRunner::reset() {
    stop_all();
    first_order_.cancel();
    entries_.clear();
    wanted_.clear();
    set_held({});
}

void AnalysisRunner::take_made() {
    const Project& project = made()->project();
    emit made_changed();
    std::erase_if(entries_, [&](const auto& entry) { return !project.find_analysis(entry.first); });
    const std::deque<RunKey> waiting = runs_.waiting();
    for (const RunKey& key : waiting)
        if (!project.find_analysis(key.analysis)) runs_.take_out(key);
    for (const AnalysisEntry& analysis : project.analyses)
        update_entry(analysis.id, *made()->find_analysis(analysis.id));
    if (live_) propagate();
    if (live_ && !runs_.waiting().empty()) runs_.settle();
    start_wanted();
    announce_idle();
}

void AnalysisRunner::take_none(const ProjectSnapshot& project, const Error& error) {
    wanted_.clear();
    all_wanted_ = false;
    std::erase_if(entries_, [&](const auto& entry) { return !project->find_analysis(entry.first); });
    for (const AnalysisEntry& analysis : project->analyses) {
        AnalysisStatus& entry = entries_[analysis.id];
        stop(to_qt(analysis.id));
        entry.prepared.reset();
        compare(entry);
        set_state(analysis.id, RunState::failed, error.message);
    }
    announce_idle();
}

void AnalysisRunner::fail_entry(const std::string& id, const Error& error) {
    const auto entry = entries_.find(id);
    if (entry != entries_.end() && entry->second.prepared && entry->second.held.isEmpty())
        set_state(id, RunState::failed, error.message);
}

void AnalysisRunner::update_entry(const std::string& id, const MadeAnalysis& made) {
    AnalysisStatus& entry = entries_[id];
    const bool same = entry.prepared && made.prepared &&
                      (entry.prepared == made.prepared || same_numbers(*entry.prepared, *made.prepared));
    entry.prepared = made.prepared;
    entry.warnings = this->made()->warnings_of(id);
    const auto held = held_.find(id);
    entry.held = held == held_.end() ? QString() : held->second;
    compare(entry);
    if (!made.prepared) {
        stop(to_qt(id));
        const Project& project = this->made()->project();
        const std::string path = entry_path(project, {SetupOwner::analysis, id});
        const bool unfinished = lack_of(project, this->made()->problems(), path) == Lack::fields;
        set_state(id, unfinished ? RunState::incomplete : RunState::failed, first_error(made.problems, {}));
        return;
    }
    if (entry.is_of_present() && entry.result_of != entry.prepared) {
        take_present_names(entry);
        emit result_changed(to_qt(id));
    }
    if (!entry.held.isEmpty()) {
        set_state(id, RunState::failed, to_std(entry.held));
    } else if (!same) {
        if (live_) runs_.stop({id});
        set_state(id, resting_state(entry));
    } else {
        emit state_changed(to_qt(id));  // titles and warnings may differ
    }
}

void AnalysisRunner::propagate() {
    std::vector<PreparedPointer> without;
    for (const auto& [id, entry] : entries_)
        if (entry.state == RunState::out_of_date && entry.prepared && entry.held.isEmpty())
            without.push_back(entry.prepared);
    if (without.empty()) return;
    const auto failed = [this, without](const Error& error) {
        for (const PreparedPointer& analysis : without) fail_entry(analysis->id, error);
        announce_idle();
    };
    const auto propagate = [this, without](const std::stop_token& stop) -> JobQueue::Delivery {
        FirstOrder results;
        for (const PreparedPointer& analysis : without)
            if (!stop.stop_requested())
                results.emplace_back(
                    analysis, std::make_shared<Result<UncertaintyResult>>(backend_.first_order(*analysis)));
        return [this, results] { take_first_order(results); };
    };
    first_order_.start(propagate, failed);
}

void AnalysisRunner::take_first_order(const FirstOrder& results) {
    for (const auto& [analysis, result] : results) {
        const auto entry = entries_.find(analysis->id);
        if (entry == entries_.end() || entry->second.is_of_present()) continue;
        deliver(analysis, ResultStage::first_order, result);
        if (live_ && entry->second.state == RunState::out_of_date) enqueue(analysis->id);
    }
    if (!runs_.waiting().empty()) runs_.settle();
    announce_idle();
}

void AnalysisRunner::start_wanted() {
    if (maker_.is_making()) return;
    for (const std::string& id : std::exchange(wanted_, {})) run(to_qt(id));
    if (std::exchange(all_wanted_, false)) run_all();
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
        if (!entry.prepared) continue;  // its problems are the greater trouble
        set_state(id, reason.isEmpty() ? resting_state(entry) : RunState::failed, to_std(reason));
        if (live_ && entry.state == RunState::out_of_date) enqueue(id);
    }
    runs_.begin();
}

void AnalysisRunner::set_live(bool live) {
    live_ = live;
    if (live) run_all();
}

void AnalysisRunner::run(const QString& id) {
    if (maker_.is_making()) {
        wanted_.insert(id.toStdString());
        return;
    }
    const auto entry = entries_.find(id.toStdString());
    if (entry == entries_.end() || !entry->second.prepared || !entry->second.held.isEmpty()) return;
    runs_.stop({entry->first});
    enqueue(entry->first);
    runs_.begin();
}

void AnalysisRunner::run_all() {
    all_wanted_ = maker_.is_making();
    if (all_wanted_) return;
    for (const auto& [id, entry] : entries_)
        if (entry.prepared && entry.held.isEmpty() &&
            (entry.state == RunState::out_of_date || entry.state == RunState::failed))
            enqueue(id);
    runs_.begin();
}

void AnalysisRunner::stop(const QString& id) {
    const std::string key = id.toStdString();
    wanted_.erase(key);
    const bool waited = runs_.take_out({key});
    if (!runs_.stop({key}) && waited) set_state(key, resting_state(entries_[key]));
    announce_idle();
}

void AnalysisRunner::stop_all() {
    studies_.stop_all();
    designs_.stop_all();
    kept_.stop();
    wanted_.clear();
    all_wanted_ = false;
    while (!runs_.waiting().empty()) stop(to_qt(runs_.waiting().front().analysis));
    runs_.stop_active();
}

void AnalysisRunner::enqueue(const std::string& id) {
    runs_.push({id});
    set_state(id, RunState::running);
}

RunQueue::Run AnalysisRunner::begin_run(const std::string& id) {
    const AnalysisStatus& entry = entries_[id];
    const PreparedPointer analysis = entry.prepared;
    const bool preview =
        live_ && wants_preview(analysis->options) && resting_state(entry) != RunState::up_to_date;
    return [this, analysis, preview](const RunControl& control) -> JobQueue::Delivery {
        if (preview && !control.stop.stop_requested()) {
            const RunControl quiet{control.stop, {}, control.threads};
            auto early =
                std::make_shared<Result<UncertaintyResult>>(backend_.full(preview_of(*analysis), quiet));
            if (*early) runs_.post([=, this] { deliver(analysis, ResultStage::preview, early); });
        }
        auto result = std::make_shared<Result<UncertaintyResult>>(
            control.stop.stop_requested() ? Result<UncertaintyResult>(fail(ErrorCode::cancelled, {}))
                                          : backend_.full(*analysis, control));
        return [this, analysis, result] { deliver(analysis, ResultStage::complete, result); };
    };
}

void AnalysisRunner::deliver(const PreparedPointer& analysis, ResultStage stage, const SharedResult& result) {
    const auto entry = entries_.find(analysis->id);
    if (entry == entries_.end()) return;
    if (*result) {
        keep(analysis->id, analysis, stage, ResultPointer(result, &**result));
    } else if (result->error().code != ErrorCode::cancelled && entry->second.prepared &&
               same_numbers(*entry->second.prepared, *analysis) && entry->second.held.isEmpty()) {
        set_state(analysis->id, RunState::failed, result->error().message);
    }
}

void AnalysisRunner::finish_run(const std::string& id) {
    const auto entry = entries_.find(id);
    if (entry != entries_.end() && !runs_.waits({id}) && entry->second.state == RunState::running)
        set_state(id, resting_state(entry->second));
}

void AnalysisRunner::keep(const std::string& id, const PreparedPointer& analysis, ResultStage stage,
                          ResultPointer result) {
    AnalysisStatus& entry = entries_[id];
    const bool is_newest = entry.prepared && same_numbers(*entry.prepared, *analysis);
    if (!is_newest && entry.is_of_present()) return;  // never replace a current result by a stale one
    entry.result = std::move(result);
    entry.result_of = analysis;
    entry.stage = stage;
    entry.has_same_numbers = is_newest;
    if (is_newest) take_present_names(entry);
    emit result_changed(to_qt(id));
}

/// Names have no part in the numbers: a result stays current when something is renamed.
void AnalysisRunner::take_present_names(AnalysisStatus& entry) {
    if (entry.result_of == entry.prepared) return;
    const bool same_words = entry.result_of->propagated == entry.prepared->propagated &&
                            entry.result_of->style == entry.prepared->style;
    entry.result_of = entry.prepared;
    if (same_words) return;
    auto renamed = std::make_shared<UncertaintyResult>(*entry.result);
    take_names(*renamed, entry.prepared->model->outputs(), entry.prepared->inputs);
    take_style(*renamed, entry.prepared->style);
    entry.result = std::move(renamed);
}

RunState AnalysisRunner::resting_state(const AnalysisStatus& status) const {
    return status.is_current() ? RunState::up_to_date : RunState::out_of_date;
}

void AnalysisRunner::set_state(const std::string& id, RunState state, const Message& message) {
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
    kept_.begin();  // if it waited for that
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
