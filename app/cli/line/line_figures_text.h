// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/line_figures.h"

#include <QJsonObject>
#include <QString>

namespace codewheel {

// How a line or an encoder on it has done, in two lines.
QString figuresText(const LineFigures &figures);
QJsonObject figuresJson(const LineFigures &figures); // times in microseconds

} // namespace codewheel
