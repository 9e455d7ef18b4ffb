// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/word_format.h"

#include <QMenu>

namespace codewheel {

// "Copy as": the notation of copied words. For the context menus of everything that shows words, which have
// the two words of a PLC beside it, with a key.
class CopyMenu : public QMenu
{
    Q_OBJECT

public:
    // `view` is what the key is for, and all that is in it.
    explicit CopyMenu(QWidget *view);

    QAction *plcWords() const { return m_plcWords; }
    void setOffered(bool offered); // both
Q_SIGNALS:
    void chosen(codewheel::WordNotation notation);

private:
    QAction *m_plcWords;
};

} // namespace codewheel
