// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"

#include <QObject>

#include <functional>

class QAction;
class QStackedWidget;

namespace codewheel {

class BusViews;
class Plant;
class StructureView;
class WhyPage;
class WindowActions;

// The page that says why there is no data, about the row chosen in the bus structure: what opens it, what it
// shows with each frame, and the actions that its button stands for.
class WhyInWindow : public QObject
{
    Q_OBJECT

public:
    // All of it outlives the page.
    struct Parts
    {
        Plant &plant;
        WindowActions &actions;
        StructureView &structure;
        QStackedWidget &pages;
        QAction &isInPositionMode;                    // says so of the chosen encoder
        std::function<BusViews *(BusId bus)> viewsOf; // null: it has none
    };

    WhyInWindow(Parts parts, QObject *parent);

    void showFrame();

private:
    void open();
    void look();
    void showLastTry();
    QString about(Place row) const;
    QAction *actionFor(DataCheck::Action action) const; // null: none

    const Parts m_parts;
    WhyPage *m_page;
};

} // namespace codewheel
