// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_figures.h"

#include <QJsonObject>
#include <QString>

namespace codewheel {

// The statistics of a line or of an encoder on it, in two lines.
QString figuresText(const EscLineFigures &figures);
QJsonObject figuresJson(const EscLineFigures &figures); // times in microseconds

} // namespace codewheel
