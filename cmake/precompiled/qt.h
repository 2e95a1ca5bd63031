// Precompiled for the folders of ui that have widgets.
#pragma once

#include <QAbstractItemModel>
#include <QAction>
#include <QBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QString>
#include <QVariant>
#include <QWidget>

#include "cmake/precompiled/core.h"
