// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/word_format.h"

#include <QMenu>

namespace codewheel {

// "Copy as": the notation of copied words. For the context menus of everything that shows words.
class CopyMenu : public QMenu
{
    Q_OBJECT

public:
    explicit CopyMenu(QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(codewheel::WordNotation notation);
};

} // namespace codewheel
