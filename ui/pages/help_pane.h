// The pages of help: each at the field, section or term that is asked for.
#pragma once

#include <QTextBlock>
#include <QWidget>
#include <vector>

#include "core/manual/help_page.h"

class QTextBrowser;
class QUrl;

namespace covaria::ui {

class HelpPane : public QWidget {
    Q_OBJECT
public:
    explicit HelpPane(QWidget* parent = nullptr);

    /// Shows a page by its id, or a place on one ("model-equation-field-quantities"); false: there is none.
    bool show_place(const QString& anchor);
    bool has_place(const QString& anchor);
    /// Shows words that are no page of their own.
    void show_words(const QString& title, const QString& markdown);

    const QString& place() const { return place_; }
    /// Words of the heading or field that is shown.
    QString words_at_place() const;
    QTextBrowser& browser() { return *browser_; }
    const std::vector<HelpPage>& pages();

signals:
    void title_changed(const QString& title);

private:
    const HelpPage* page_of(const QString& anchor);
    void show_blocks(const QString& title, const std::vector<ReportBlock>& blocks);
    void go_to_place();
    void follow(const QUrl& link);
    QTextBlock block_at_place() const;

    QTextBrowser* browser_;
    std::vector<HelpPage> pages_;
    std::string page_;  ///< id of the page that is shown
    QString place_;
};

}  // namespace covaria::ui
