// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_at_work.h"
#include "app/window/buses/work_under_way.h"
#include "app/window/look/panels.h"
#include "bus/data_check.h"
#include "vocabulary/kind_data.h"
#include "vocabulary/training_act.h"
#include "widgets/structure/fault_banner.h"
#include "widgets/transfer/replace_step.h"

#include <QAction>
#include <QObject>

#include <any>
#include <functional>
#include <optional>
#include <vector>

class QMenu;
class QStackedWidget;
class QVBoxLayout;

namespace codewheel {

class DevicePanel;
class InlineMessage;
struct ProgramSettings;
class Leaving;
class StatusLine;
class StructureEditor;
class TrainingArea;
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

// What one bus adds to the window, depending on its kind: panels, pages, and the work of its kind's actions.
class BusViews : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    ~BusViews() override;

    // Its pages, for the panels of its kind and for panel::training.
    virtual std::vector<std::pair<const Panel *, QWidget *>> pages() const = 0;
    // The page that compares it with the project; null: no project plans such a bus.
    virtual QWidget *comparison() const = 0;
    virtual bool tellsState() const { return false; } // at the start of the status line
    virtual QMenu *menu() const { return nullptr; }   // of its row in the bus structure; null: none

    bool owns(const QWidget *page) const;
    // Whether actions, docks and status line refer to this bus.
    void setCurrent(bool isCurrent);
    // The name its actions use; empty: it cannot be confused with another bus. `isDoubtful`: it is one of
    // several and none of them is chosen, so no action connects or changes it.
    void setCalled(const QString &called, bool isDoubtful);
    // The device chosen in the window, if it is on this bus.
    virtual void setChosen(std::optional<Place>) {}
    // What is chosen in the window is of a recording: nothing is sent from the panels of other buses.
    virtual void setRecordingChosen(bool) {}
    // Whether a bus of its kind can have the keys of bus_keys.h, and whether this one has them now.
    virtual bool takesKeys() const { return false; }
    virtual void setHasKeys(bool) {}
    virtual void open() = 0;              // its row was opened
    virtual void connectBus() { open(); } // or shows where to do that; sends nothing
    virtual void connectTraining() {}     // to a simulated link
    // With a link that a search has found, and what it has found there, as their kind knows them.
    virtual void connectFound(const KindData &, const std::vector<KindData> &) {}
    // A device was opened. False: show its words, as for any device.
    virtual bool open(Place) { return false; }
    // Whether a fault plan can be loaded now; loads it, and shows it or what is wrong with it.
    virtual bool takesFaultPlans() const { return false; }
    virtual void loadFaultPlan(const QString &) {}
    // Calls `then` once it may go to Operate; not at all if the user stays in Watch.
    virtual void askToOperate(const std::function<void()> &then) { then(); }
    // What its pages have collected, for those in another language; its own are about to go.
    virtual std::any takeWork() { return {}; }
    virtual void goOn(const std::any &) {}
    virtual void showFrame() {}                          // with each frame of the window
    virtual void useSettings(const ProgramSettings &) {} // at first, and when they have changed
    virtual void compare() {}                            // reports how its bus differs from the project
    // Whether an action that its faults name is available now; carries it out.
    virtual FaultBanner::Offer offer(const Fault &, FaultAction) const { return {}; }
    virtual void act(const Fault &, FaultAction) {}
    virtual bool isWriting() const { return false; } // a page of it: the window stays until that has ended
    // What leaving the bus would cut off; empty: nothing.
    virtual std::optional<WorkUnderWay> underWay() const { return {}; }
    // Ends that in good order, then says whether nothing of it is left in doubt; otherwise it is shown.
    virtual void breakOff(const std::function<void(bool isSettled)> &then) { then(true); }
    // What its kind adds to the replacement of an encoder at a place of it.
    virtual ReplaceStepsOfKind replaceSteps(Replacing &) { return {}; }
    // The action of its kind for what a check proposes; null: it has none for that.
    virtual QAction *actionFor(DataCheck::Action) const { return nullptr; }

Q_SIGNALS:
    void panelRequested(const codewheel::Panel &panel); // to be shown
    void told(const codewheel::Message &message);
    void goToWanted(codewheel::Place place); // to its row in the bus structure
    void devicesChanged();                   // another ring was read in: the choice stays if it still exists

protected:
    bool isCurrent() const { return m_isCurrent; }
    const QString &called() const { return m_called; }
    bool isMeant() const { return m_isCurrent && !m_isDoubtful; } // for actions that change it
    virtual void showCurrent() = 0;                               // one of the above has changed
    // Actions apply to the bus of its kind that is chosen, or was chosen last.
    template <typename What>
    void onAction(QAction *action, What what)
    {
        connect(action, &QAction::triggered, this, [this, what] {
            if (m_isCurrent)
                what();
        });
    }
    // A page or panel in the window, destroyed with the views.
    template <typename Widget>
    Widget *own(Widget *widget)
    {
        m_own.push_back(widget);
        return widget;
    }
    // Whether its simulated bus can begin anew: in its training panel, where it has one, and, if it is meant,
    // by the action.
    void showAfresh(TrainingArea *panel, QAction *action, const QString &whyNot);
    // A place without a node is the bus itself.
    void tellTraining(Place place, const TrainingAct &what, MessageCode id = MessageId::training);

private:
    std::vector<QWidget *> m_own;
    bool m_isCurrent = false;
    bool m_isDoubtful = false;
    QString m_called;
};

} // namespace codewheel
