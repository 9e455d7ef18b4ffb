// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/bus_at_work.h"
#include "app/window/panels.h"
#include "widgets/structure/fault_banner.h"

#include <QAction>
#include <QObject>

#include <vector>

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
    WindowActions &actions;
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
    ~BusViews() override;

    // Its pages, of the panels of its kind and of panel::training.
    virtual std::vector<std::pair<const Panel *, QWidget *>> pages() const = 0;
    // The page that lays it beside the project.
    virtual QWidget *comparison() const = 0;
    virtual bool tellsState() const { return false; } // at the head of the status line
    virtual QMenu *menu() const { return nullptr; }   // of its row in the bus structure; null: none

    bool owns(const QWidget *page) const;
    // This bus is meant by actions, docks and status line, or another one is.
    void setCurrent(bool isCurrent);
    // How its actions call it; empty: nobody can take another bus for it. `isDoubtful`: it is one of several,
    // and none of them is chosen, so no action connects or changes it.
    void setCalled(const QString &called, bool isDoubtful);
    // The device that is chosen in the window, if it is one of this bus.
    virtual void setChosen(std::optional<Place>) {}
    virtual void open() = 0;              // its row was opened
    virtual void connectBus() { open(); } // or leads to where that is done; nothing is sent
    virtual void connectTraining() {}     // to its simulated link
    // A device was opened. False: its words are to be looked at, as everybody's.
    virtual bool open(Place) { return false; }
    virtual void showFrame() {} // with each frame of the window
    virtual void compare() {}   // it says how its bus differs from the project
    // What its faults name as an action, as it can be had now; done.
    virtual FaultBanner::Offer offer(const Fault &, FaultAction) const { return {}; }
    virtual void act(const Fault &, FaultAction) {}

Q_SIGNALS:
    void panelRequested(const codewheel::Panel &panel); // it is to be seen
    void told(const codewheel::Message &message);
    void goToWanted(codewheel::Place place); // to its row in the bus structure
    void devicesChanged(); // another ring was read in: what is chosen stays so if it is there

protected:
    bool isCurrent() const { return m_isCurrent; }
    const QString &called() const { return m_called; }
    bool isMeant() const { return m_isCurrent && !m_isDoubtful; } // by actions that change it
    virtual void showCurrent() = 0;                               // one of these is another
    // Actions mean the bus of its kind that is chosen, or was chosen last.
    template <typename What>
    void onAction(QAction *action, What what)
    {
        connect(action, &QAction::triggered, this, [this, what] {
            if (m_isCurrent)
                what();
        });
    }
    // A page or panel in the window, which goes with the views.
    template <typename Widget>
    Widget *own(Widget *widget)
    {
        m_own.push_back(widget);
        return widget;
    }
    // Without a node it is of the bus itself.
    void tellTraining(Place place, const QString &what, MessageId id = MessageId::training);

private:
    std::vector<QWidget *> m_own;
    bool m_isCurrent = false;
    bool m_isDoubtful = false;
    QString m_called;
};

} // namespace codewheel
