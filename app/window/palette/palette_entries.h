// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"
#include "vocabulary/place.h"
#include "widgets/palette/palette_source.h"

#include <QList>

class QAction;
class QDockWidget;
class QMainWindow;
class QStackedWidget;

namespace codewheel {

class Buses;
class Catalog;
class OtherLanguage;
class ProjectDocument;
class ShownEncoder;
class StructureView;

// What the command palette of the window finds.

// The actions of all menus: triggered exactly as by the menu. `usual`: offered before anything is typed.
std::vector<PaletteEntry> actionEntries(const QMainWindow &window, const QList<QAction *> &usual,
                                        OtherLanguage &otherLanguage);

// The buttons of the panels and of the open page: pressed where they are, in sight.
std::vector<PaletteEntry> buttonEntries(const QMainWindow &window, const QStackedWidget &pages,
                                        const std::function<void(const QDockWidget &)> &show,
                                        OtherLanguage &otherLanguage);

// The parameters of an encoder. Nothing is written: one is only shown.
std::vector<PaletteEntry> parameterEntries(const ShownEncoder &encoder,
                                           const std::function<void(Parameter)> &show);

// The devices of all buses, connected or planned.
std::vector<PaletteEntry> deviceEntries(const StructureView &structure, const Buses &buses,
                                        const ProjectDocument &project, const Catalog &catalog,
                                        const std::function<void(Place)> &choose);

} // namespace codewheel
