// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/link_figures.h"

#include <QJsonObject>
#include <QString>

namespace codewheel {

// The statistics of a link to a ring, in a few lines.
QString figuresText(const LinkFigures &figures);
QJsonObject figuresJson(const LinkFigures &figures); // times in microseconds

} // namespace codewheel
