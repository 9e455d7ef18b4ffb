// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

#include <QMainWindow>

class QAbstractButton;
class QDockWidget;
class QStackedWidget;

namespace codewheel {

// The buttons of the panels and of the open page, for the command palette: pressed where they are, in sight.
class PaletteButtons : public PaletteSource
{
public:
    using ShowPanel = std::function<void(const QDockWidget &)>;

    PaletteButtons(const QMainWindow &window, const QStackedWidget &pages, ShowPanel show);

    void begin() override;
    std::vector<PaletteEntry> next() override;

private:
    PaletteEntry entryOf(QAbstractButton &button, const QString &where, const QDockWidget *panel) const;

    const QMainWindow &m_window;
    const QStackedWidget &m_pages;
    const ShowPanel m_show;
    bool m_isGiven = false;
};

} // namespace codewheel
