// One check at a time; while it runs only the newest request is remembered.
#include "ui/document/problem_checker.h"

#include <QMetaObject>

namespace covaria::ui {

ProblemChecker::ProblemChecker(Check check, QObject* parent) : QObject(parent), check_(std::move(check)) {
    pool_.setMaxThreadCount(1);
}

ProblemChecker::~ProblemChecker() {
    pool_.waitForDone();
}

void ProblemChecker::request(ProjectSnapshot snapshot) {
    waiting_ = std::move(snapshot);
    ++latest_;
    if (!running_) start();
}

void ProblemChecker::start() {
    running_ = true;
    pool_.start([this, snapshot = std::move(waiting_), number = latest_] {
        Problems problems;
        check_(*snapshot, problems);
        QMetaObject::invokeMethod(
            this, [this, number, found = std::move(problems)] { finish(number, found); },
            Qt::QueuedConnection);
    });
    waiting_.reset();
}

void ProblemChecker::finish(quint64 number, Problems problems) {
    running_ = false;
    if (waiting_) start();
    if (number != latest_) return;
    problems_ = std::move(problems);
    emit checked();
}

void ProblemChecker::check_now(ProjectSnapshot snapshot) {
    ++latest_;
    waiting_.reset();
    problems_ = {};
    check_(*snapshot, problems_);
    emit checked();
}

}  // namespace covaria::ui
