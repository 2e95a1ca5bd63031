// Checks project snapshots in a worker thread; the latest snapshot wins.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "core/project/project.h"

namespace covaria::ui {

using ProjectSnapshot = std::shared_ptr<const Project>;

class ProblemChecker : public QObject {
    Q_OBJECT
public:
    using Check = std::function<void(const Project&, Problems&)>;
    /// `check` is called from a worker thread.
    explicit ProblemChecker(Check check, QObject* parent = nullptr);
    ~ProblemChecker() override;

    /// Snapshots that arrive while one is being checked replace each other.
    void request(ProjectSnapshot snapshot);
    /// Synchronous twin of `request`; emits `checked` before it returns.
    void check_now(ProjectSnapshot snapshot);
    const Problems& problems() const { return problems_; }

signals:
    void checked();

private:
    void start();
    void finish(quint64 number, Problems problems);

    Check check_;
    QThreadPool pool_;
    ProjectSnapshot waiting_;
    bool running_ = false;
    quint64 latest_ = 0;
    Problems problems_;
};

}  // namespace covaria::ui
