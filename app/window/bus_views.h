// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/bus_at_work.h"

#include <QObject>

#include <vector>

class QAction;
class QMenu;
class QStackedWidget;
class QVBoxLayout;

namespace codewheel {

class DevicePanel;
class InlineMessage;
class Leaving;
class StatusLine;
class StructureEditor;
class WindowActions;
class WindowSettings;

// What the window lends to the views of a bus. All of it outlives them.
struct WindowParts
{
    WindowSettings &settings;
    Leaving &leaving;
    const WindowActions &actions;
    QStackedWidget &pages;
    QVBoxLayout &notices; // above the pages
    InlineMessage &notice;
    StatusLine &status;
    DevicePanel &device;
    StructureEditor &editor;
};

// What one bus adds to the window, each kind its own: panels, pages, and what the actions of its kind do.
class BusViews : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    // In the dock of this name (panels.h), where the other buses of its kind have theirs.
    struct Panel
    {
        const char *dock;
        QWidget *widget;
    };
    virtual std::vector<Panel> panels() const = 0;
    virtual QMenu *menu() const { return nullptr; } // of its row in the bus structure; null: none

    // This bus is meant by actions, docks and status line, or another one is.
    virtual void setCurrent(bool isCurrent) = 0;
    // The device that is chosen in the window, if it is one of this bus.
    virtual void setChosen(std::optional<Place>) {}
    virtual void open() = 0; // its row was opened
    // A device was opened. False: its words are to be looked at, as everybody's.
    virtual bool open(Place) { return false; }
    virtual void showPicture() {} // with each picture of the window

Q_SIGNALS:
    void panelRequested(const char *dock); // it is to be seen
    void told(const codewheel::Message &message);
    void encoderChanged(); // something of the chosen encoder that actions depend on
    void devicesChanged(); // another ring was read in: what is chosen stays so if it is there
    void startRequested(); // of this bus
    void stopRequested();
};

// The list of kinds: the views of each.
BusViews *makeBusViews(BusAtWork &bus, const WindowParts &parts, QObject *parent);

} // namespace codewheel
