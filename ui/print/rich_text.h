// A paragraph of HTML set to a width: measured, then painted on a page.
#pragma once

#include <QColor>
#include <QFont>
#include <QString>
#include <memory>

#include "ui/print/page_style.h"

class QPainter;
class QTextDocument;

namespace covaria::ui {

class RichText {
public:
    RichText(const PageStyle& style, TextRole role, const QString& html, Qt::Alignment align = Qt::AlignLeft);

    double natural_width() const;    ///< on one line
    double narrowest_width() const;  ///< width of the longest word
    void set_width(double width);
    double height() const;
    double first_baseline() const;  ///< below the top
    void paint(QPainter& painter, QPointF top_left, const QColor& color = PageStyle::ink()) const;

private:
    std::shared_ptr<QTextDocument> document_;
};

}  // namespace covaria::ui
