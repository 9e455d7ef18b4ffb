// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

#include <QMainWindow>

class QAbstractButton;
class QAction;
class QDockWidget;
class QStackedWidget;

namespace codewheel {

class OtherLanguage;
struct ListedMenu;

// The buttons of the panels and of the open page, for the command palette: pressed where they are, in sight.
class PaletteButtons : public PaletteSource
{
public:
    using ShowPanel = std::function<void(const QDockWidget &)>;

    PaletteButtons(const QMainWindow &window, const QStackedWidget &pages, ShowPanel show,
                   OtherLanguage &otherLanguage);

    void begin() override;
    std::vector<PaletteEntry> next() override;

private:
    struct Where
    {
        QString title;
        const QDockWidget *panel; // null: a page
    };

    void add(const QWidget &part, const Where &where, const std::vector<ListedMenu> &menus,
             std::vector<PaletteEntry> &entries) const;
    PaletteEntry entryOf(QAbstractButton &button, const Where &where) const;
    PaletteEntry entryOf(QAction &action, const Where &where) const;

    const QMainWindow &m_window;
    const QStackedWidget &m_pages;
    const ShowPanel m_show;
    OtherLanguage &m_otherLanguage;
    bool m_isGiven = false;
};

} // namespace codewheel
