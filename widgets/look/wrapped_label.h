// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace codewheel {

// A sentence on as many lines as it needs. `id` is for tests.
inline QLabel *wrappedLabel(QWidget *parent, const char *id = "")
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    label->setObjectName(QLatin1String(id));
    return label;
}

} // namespace codewheel
