#include "ui/run/kept_states.h"

#include <set>
#include <utility>

#include "ui/document/document.h"
#include "ui/run/analysis_runner.h"
#include "ui/theme/strings.h"

namespace covaria::ui {
namespace {

Result<UncertaintyResult> compute(const ProjectSnapshot& project, const std::string& analysis,
                                  const MadeProject::Pointer& near, const RunBackend& backend,
                                  const RunControl& control) {
    const MadeProject::Pointer made = MadeProject::make(project, near);
    if (const auto prepared = made->analysis(analysis)) return backend.full(*prepared, control);
    return fail(ErrorCode::bad_input, first_error(made->problems_of_analysis(analysis), {}));
}

std::string time_of_now() {
    return to_std(QDateTime::currentDateTimeUtc().toString(Qt::ISODate));
}

/// Whether both have the same numbers, whenever they were computed.
bool same_origin(const UncertaintyResult& a, const UncertaintyResult& b) {
    const std::string& fingerprint = a.provenance.project_fingerprint;
    return !fingerprint.empty() && fingerprint == b.provenance.project_fingerprint;
}

}  // namespace

QDateTime KeptResult::at() const {
    return QDateTime::fromString(to_qt(state.at), Qt::ISODate).toLocalTime();
}

KeptStates::KeptStates(const AnalysisRunner& runner, const RunBackend& backend, Execution execution)
    : runner_(runner),
      backend_(backend),
      runs_([this](const RunKey& key) { return begin_run(key); }, execution) {
    connect(&runs_, &RunQueue::failed, this, [this](const RunKey& key, const Error& error) {
        const auto entry = kept_.find(to_qt(key.analysis));
        if (entry == kept_.end() || runs_.waits(key)) return;
        entry->second.trouble = to_qt(error.message);
        emit changed(entry->first);
    });
    connect(&runs_, &RunQueue::progress_changed, this,
            [this](const RunKey& key, const RunProgress& progress) {
                emit progress_changed(to_qt(key.analysis), progress);
            });
    connect(&runs_, &RunQueue::idle, this, &KeptStates::idle);
}

void KeptStates::follow(Document& document) {
    document_ = &document;
    connect(&document, &Document::project_changed, this, [this] { take(document_->project().kept); });
    take(document.project().kept);
}

void KeptStates::take(const std::vector<KeptState>& states) {
    std::set<QString> other;
    for (const auto& [analysis, kept] : kept_)
        if (!find_kept(states, to_std(analysis))) other.insert(analysis);
    auto before = std::exchange(kept_, {});
    for (const KeptState& state : states) {
        const QString analysis = to_qt(state.analysis);
        const auto same = before.find(analysis);
        if (same != before.end() && same->second.state == state) {
            kept_[analysis] = std::move(same->second);
            continue;
        }
        const bool is_fresh = fresh_ && fresh_->state == state;
        kept_[analysis] = is_fresh ? *std::exchange(fresh_, std::nullopt) : KeptResult{state};
        other.insert(analysis);
    }
    for (const QString& analysis : other) {
        emit changed(analysis);
        want(analysis);
    }
}

bool KeptStates::can_keep(const QString& analysis) const {
    return runner_.made() && runner_.status(analysis).is_current();
}

void KeptStates::compare_with(const QString& analysis, const Project& project, const std::string& other,
                              const QString& name) {
    if (!document_) return;
    const KeptState state = state_of_other(project, other, to_std(name), to_std(analysis), time_of_now());
    document_->apply(tr("Compare with %1").arg(name), [&](Project& edited) { put_kept(edited.kept, state); });
}

void KeptStates::keep(const QString& analysis) {
    if (!document_ || !can_keep(analysis)) return;
    const KeptState state =
        state_to_keep(runner_.made()->project(), document_->project(), to_std(analysis), time_of_now());
    fresh_ = KeptResult{state, runner_.status(analysis).result};
    if (!document_->apply(tr("Keep state"), [&](Project& project) { put_kept(project.kept, state); }))
        fresh_.reset();
}

void KeptStates::discard(const QString& analysis) {
    if (!document_) return;
    document_->apply(tr("Discard kept state"),
                     [&](Project& project) { discard_kept(project.kept, to_std(analysis)); });
}

const KeptResult* KeptStates::find(const QString& analysis) const {
    const auto found = kept_.find(analysis);
    return found == kept_.end() ? nullptr : &found->second;
}

ResultPointer KeptStates::before(const QString& analysis, const ResultPointer& now) const {
    const KeptResult* kept = find(analysis);
    const bool other =
        kept && kept->result && now && kept->result != now && !same_origin(*kept->result, *now);
    return other ? kept->result : nullptr;
}

void KeptStates::want(const QString& analysis) {
    const KeptResult* kept = find(analysis);
    if (!kept || kept->result || !kept->trouble.isEmpty() || !runner_.status(analysis).result) return;
    runs_.push({to_std(analysis)});
    begin();
}

void KeptStates::stop() {
    while (!runs_.waiting().empty()) runs_.take_out(RunKey(runs_.waiting().front()));
    runs_.stop_active();
}

RunQueue::Run KeptStates::begin_run(const RunKey& key) {
    if (runner_.is_computing()) return {};  // present edits come first
    const KeptResult* kept = find(to_qt(key.analysis));
    const ProjectSnapshot project = kept && !kept->result ? kept->state.project : nullptr;
    const std::string compared = kept ? kept->state.compared() : std::string();
    return [this, key, project, compared,
            near = runner_.made()](const RunControl& control) -> JobQueue::Delivery {
        if (!project) return {};
        const auto computed =
            std::make_shared<Result<UncertaintyResult>>(compute(project, compared, near, backend_, control));
        return [this, key, project, computed] { deliver(to_qt(key.analysis), project, computed); };
    };
}

void KeptStates::deliver(const QString& analysis, const ProjectSnapshot& project,
                         const std::shared_ptr<Result<UncertaintyResult>>& computed) {
    const auto entry = kept_.find(analysis);
    if (entry == kept_.end() || entry->second.state.project != project) return;  // another one is kept by now
    if (*computed)
        entry->second.result = ResultPointer(computed, &**computed);
    else if (computed->error().code != ErrorCode::cancelled)
        entry->second.trouble = to_qt(computed->error().message);
    else
        return;
    emit changed(analysis);
}

}  // namespace covaria::ui
