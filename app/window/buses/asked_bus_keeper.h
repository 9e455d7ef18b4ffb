// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <QObject>

namespace codewheel {

class AskedBusAtWork;
class EncoderSession;

// Keeps in the project what happens to the encoders of a bus that are asked, each change as an undo step. The
// simulated bus is not the project's: nothing is kept of its encoders, which do not exist. Used by
// AskedBusViews.
class AskedBusKeeper : public QObject
{
    Q_OBJECT

public:
    const PlannedBus *planned() const; // null: the project has no such bus
    // Encoders already in the project stay as they are.
    void keepEncoders(const std::vector<Place> &places);
    void removeEncoder(Place place);
    KindData plan() const;               // the project's; if it has none, the open one
    void keepLink(const KindData &plan); // where it is now

protected:
    // Of its kind, as undo steps.
    struct Steps
    {
        QString link;
        QString encoders; // taken over
    };
    AskedBusKeeper(const AskedBusAtWork &bus, Steps steps, QObject *parent); // `bus` must outlive it

    const EncoderSession *sessionOf(Place place) const; // also null on the simulated bus
    // The planned encoder at its place; added as it is connected if the bus has none there yet.
    ProjectDevice &plannedEncoder(std::vector<ProjectDevice> &encoders,
                                  const EncoderSession &connected) const;
    void edit(KindData plan, const QString &what); // of the bus
    void edit(std::vector<ProjectDevice> after, const QString &what);
    std::vector<ProjectDevice> encoders() const; // of the project

private:
    virtual void takeUp(ProjectDevice &, const EncoderSession &) const {} // what only its kind knows

    const AskedBusAtWork &m_bus;
    const Steps m_steps;
};

} // namespace codewheel
