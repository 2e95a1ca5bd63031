// Results that were kept, each with the project that it is of: what a later state is compared with, and what
// can be gone back to.
#pragma once

#include <QDateTime>
#include <map>

#include "ui/document/project_maker.h"
#include "ui/run/run_backend.h"

namespace covaria::ui {

class AnalysisRunner;

struct KeptState {
    ResultPointer result;     ///< never null
    ProjectSnapshot project;  ///< as it was evaluated
    QString words;            ///< how the result came about
    QDateTime at;
};

/// At most one for each analysis; forgotten with the project.
class KeptStates : public QObject {
    Q_OBJECT
public:
    explicit KeptStates(AnalysisRunner& runner, QObject* parent = nullptr);

    /// Only a result that counts is kept: of the project as it is now, with all its trials.
    bool can_keep(const QString& analysis) const;
    /// Takes the place of what was kept of the analysis before.
    void keep(const QString& analysis);
    void discard(const QString& analysis);
    void clear();
    /// Null: nothing is kept.
    const KeptState* find(const QString& analysis) const;

signals:
    void changed(const QString& analysis);

private:
    AnalysisRunner& runner_;
    std::map<QString, KeptState> kept_;
};

}  // namespace covaria::ui
