// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

#include <QList>

class QAction;
class QMainWindow;

namespace codewheel {

class OtherLanguage;

// The actions of all menus of the window, for its command palette: triggered exactly as by the menu.
class PaletteActions : public PaletteSource
{
public:
    // `usual`: offered before anything is typed.
    PaletteActions(const QMainWindow &window, QList<QAction *> usual, OtherLanguage &otherLanguage);

    void begin() override;
    std::vector<PaletteEntry> next() override;

private:
    PaletteEntry entryOf(QAction &action, const QString &menu) const;

    const QMainWindow &m_window;
    const QList<QAction *> m_usual;
    OtherLanguage &m_otherLanguage;
    bool m_isGiven = false;
};

} // namespace codewheel
