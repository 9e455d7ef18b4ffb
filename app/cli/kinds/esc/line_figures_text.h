// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/line_figures.h"

#include <QJsonObject>
#include <QString>

namespace codewheel {

// The statistics of a line or of an encoder on it, in two lines.
QString figuresText(const LineFigures &figures);
QJsonObject figuresJson(const LineFigures &figures); // times in microseconds

} // namespace codewheel
