// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace codewheel {

class WindowActions;

// The actions for rings only. All rings of a window share them (WindowActions::ofKind()).
class RingActions : public QObject
{
    Q_OBJECT

public:
    explicit RingActions(WindowActions &window);

    void disable();                                  // there is no ring for them
    void tellBus(const QString &bus);                // which ring they apply to; empty: the chosen one
    void tellWhyNotDisconnected(const QString &why); // while it is disabled
    void setHasKeys(bool has);                       // those of bus_keys.h
    // Whether the master can be asked, and the chosen device has a segment.
    void showSegment(bool hasMaster, bool isChosen);

    // Whether it is, or is planned to be, behind a gateway.
    void showRegisters(bool isGateway);
    // Whether a ring can be offered (empty: it can), and is.
    void showOffer(const QString &whyNot, bool isOffered);

    QAction *connection; // its page
    QAction *registers;  // of a gateway
    QAction *connectBus;
    QAction *disconnectBus;
    QAction *readIn;
    QAction *confirmDiagnostics;
    QAction *switchSegment; // of the chosen device
    QAction *offer;         // its page
    QAction *endOffer;
    QAction *afresh; // described by Afresh

private:
    void makeTrainingMenu(WindowActions &window);
};

} // namespace codewheel
