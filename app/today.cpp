#include "app/today.h"

#include <QDate>

namespace covaria {

std::string today() {
    return QDate::currentDate().toString(Qt::ISODate).toStdString();
}

}  // namespace covaria
