// Groups below each other, each under a head that folds it away.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <vector>

class QVBoxLayout;

namespace covaria::ui {

/// Chevron, title, and at the right what is in the group, so that it answers while it is folded.
class FoldHead : public QAbstractButton {
    Q_OBJECT
public:
    explicit FoldHead(const QString& title, QWidget* parent = nullptr);
    void set_summary(const QString& words);
    const QString& summary() const { return summary_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString summary_;
};

class FoldGroups : public QWidget {
    Q_OBJECT
public:
    explicit FoldGroups(QWidget* parent = nullptr);
    /// Adds a group, open or folded as the user left the last one of this title, else as `open` says. Without
    /// a title it has no head and is always seen.
    int add(QWidget* page, const QString& title, bool open = false);
    int count() const { return static_cast<int>(groups_.size()); }
    QWidget* page(int group) const { return at(group).page; }
    QString title(int group) const;
    /// Head of a group; null: it has no title.
    FoldHead* head(int group) const { return at(group).head; }
    bool is_open(int group) const;
    void open(int group);
    /// Opens the group unless the user has folded it.
    void offer(int group);
    /// Hides a group that is not used, with its head.
    void set_shown(int group, bool shown);
    void set_summary(int group, const QString& words);
    /// Opens all groups around a widget.
    static void reveal(const QWidget& inside);

signals:
    void opened(int group);

private:
    struct Group {
        FoldHead* head;
        QWidget* body;  ///< the page with its margins
        QWidget* page;
        bool shown = true;
    };
    const Group& at(int group) const { return groups_[static_cast<std::size_t>(group)]; }
    void follow(int group);

    QVBoxLayout* column_;
    std::vector<Group> groups_;
};

}  // namespace covaria::ui
