// Files dropped on the window: a project is opened, anything else is imported.
#pragma once

#include <QObject>

class QWidget;

namespace covaria::ui {

class FileActions;
class ImportActions;

class FileDrops : public QObject {
    Q_OBJECT
public:
    FileDrops(QWidget& window, FileActions& files, ImportActions& imports);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(const QList<QUrl>& dropped);

    FileActions& files_;
    ImportActions& imports_;
};

}  // namespace covaria::ui
