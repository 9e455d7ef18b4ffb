// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyle>

#include <optional>

class QIcon;

namespace codewheel {

// The icons of Qt's own dialogs (questions, files, buttons), drawn like those of the window. Nothing: use
// Qt's own. Called by InstrumentStyle.
std::optional<QIcon> standardLineIcon(QStyle::StandardPixmap which);

} // namespace codewheel
