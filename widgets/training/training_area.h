// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "vocabulary/training_act.h"
#include "widgets/look/scrolled_panel.h"

#include <optional>
#include <vector>

class QComboBox;
class QPushButton;
class QVBoxLayout;

namespace codewheel {

// What the training panels of all buses have in common: the field for choosing a device, and a column of
// controls for it, which scrolls if the dock is low.
class TrainingArea : public ScrolledPanel
{
    Q_OBJECT

public:
    ~TrainingArea() override;

    // Chooses this device, if it has anything to train with.
    void setDevice(Place place);
    // Shows the present state, and lists the devices that are there now; called by the window with each
    // frame.
    virtual void refresh() = 0;
    // Whether the whole bus can begin anew. Without a call there is no button for it.
    void offerAfresh(bool canBegin, const QString &toolTip);

Q_SIGNALS:
    void afreshWanted();
    void acted(codewheel::Place place, const codewheel::TrainingAct &what);

protected:
    TrainingArea(const QString &toolTip, QWidget *parent);

    QVBoxLayout *column() const { return m_column; }
    void endColumn(); // below everything else
    // A place without a node is the bus itself, listed under its name. The one that was chosen stays.
    void setDevices(std::vector<Place> devices, const QString &bus = {});
    std::optional<Place> chosen() const { return m_chosen; }
    void act(const TrainingAct &what);
    virtual void leave() {} // another device is about to be chosen
    virtual QString nameOf(Place place) const { return place.toString(); } // of a device

private:
    void choose();
    void choose(Place place); // unless it is not listed

    std::vector<Place> m_devices; // by index of the field
    std::optional<Place> m_chosen;
    std::optional<Place> m_lastChosen; // also while there are none
    QComboBox *m_device;
    QVBoxLayout *m_column;
    QPushButton *m_afresh;
};

} // namespace codewheel
