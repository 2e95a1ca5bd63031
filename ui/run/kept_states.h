// Results that were kept, each with the state of the project that it is of: what a later state is compared
// with, and a user can go back to. The project holds the states; their results are computed from them
// where they are not known.
#pragma once

#include <QDateTime>
#include <map>
#include <optional>

#include "core/project/kept_state.h"
#include "ui/document/project_maker.h"
#include "ui/run/run_backend.h"
#include "ui/run/run_queue.h"

namespace covaria::ui {

class AnalysisRunner;
class Document;

struct KeptResult {
    KeptState state;
    ResultPointer result = {};  ///< null: not computed yet, or it cannot be
    QString trouble = {};       ///< why it cannot be

    QDateTime at() const;  ///< local time
};

/// Keeps at most one for each analysis, as the project has them.
class KeptStates : public QObject {
    Q_OBJECT
public:
    KeptStates(const AnalysisRunner& runner, const RunBackend& backend, Execution execution);

    /// Follows the project whose states these are.
    void follow(Document& document);

    /// Whether there is a result that counts: of the project as it is now, with all its trials.
    bool can_keep(const QString& analysis) const;
    /// An edit. Replaces the result that was kept of the analysis before.
    void keep(const QString& analysis);
    /// An edit: another analysis, of this project or of another one, is kept in place of a former state of
    /// this one.
    void compare_with(const QString& analysis, const Project& project, const std::string& other,
                      const QString& name);
    /// An edit. Forgets the kept state.
    void discard(const QString& analysis);
    /// The kept result; null: nothing is kept.
    const KeptResult* find(const QString& analysis) const;
    /// The result to compare `now` with; null where nothing is kept, or not known yet, or it is the same.
    ResultPointer before(const QString& analysis, const ResultPointer& now) const;

    /// Wants the kept result of an analysis that has a result: it is computed once nothing else is.
    void want(const QString& analysis);
    void begin() { runs_.begin(); }  ///< starts to compute what is wanted
    /// Stops: nothing is wanted any more, until it is wanted again.
    void stop();
    void set_threads(int threads) { runs_.set_threads(threads); }
    bool is_busy() const { return runs_.is_busy(); }

signals:
    void changed(const QString& analysis);
    void progress_changed(const QString& analysis, const covaria::ui::RunProgress& progress);
    void idle();

private:
    void take(const std::vector<KeptState>& states);
    RunQueue::Run begin_run(const RunKey& key);
    void deliver(const QString& analysis, const ProjectSnapshot& project,
                 const std::shared_ptr<Result<UncertaintyResult>>& computed);

    const AnalysisRunner& runner_;
    const RunBackend& backend_;
    Document* document_ = nullptr;
    std::map<QString, KeptResult> kept_;
    std::optional<KeptResult> fresh_;  ///< on its way into the project
    RunQueue runs_;                    ///< last member: its thread ends first
};

}  // namespace covaria::ui
