// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyle>

#include <optional>

class QIcon;

namespace codewheel {

// What Qt's own dialogs show (questions, files, buttons), drawn like the icons of the window. Nothing: Qt's
// own will do. Asked by InstrumentStyle.
std::optional<QIcon> standardLineIcon(QStyle::StandardPixmap which);

} // namespace codewheel
