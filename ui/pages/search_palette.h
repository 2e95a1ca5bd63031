// One field that finds everything by its name: what is found is chosen by the keyboard.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

class QLineEdit;
class QStandardItemModel;
class QTreeView;

namespace covaria::ui {

/// Something with a name that can be gone to.
struct Findable {
    QString name;
    QString kind;  ///< "analysis", "field of Tracker" ...: shown beside the name, and searched too
    std::function<void()> go;
    bool behind = false;   ///< comes after what fits alike and is not behind
    QString english = {};  ///< its name there: searched in every language, and not shown
};

/// How well `typed` fits; nothing: not at all. Every word that was typed must be in the words of `name`,
/// `english` or `kind`, its letters in order; whole words and beginnings of words of the names count most.
std::optional<int> match(const QString& typed, const Findable& findable);

class SearchPalette : public QDialog {
    Q_OBJECT
public:
    explicit SearchPalette(QWidget* parent);

    /// Opens above the parent, with the focus in the empty field.
    void search(std::vector<Findable> findables);
    QLineEdit& field() { return *field_; }
    QTreeView& found() { return *found_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show_found();
    void go();
    void choose(int row);

    std::vector<Findable> findables_;
    std::vector<std::size_t> shown_;  ///< best first
    QLineEdit* field_;
    QTreeView* found_;
    QStandardItemModel* model_;
};

}  // namespace covaria::ui
