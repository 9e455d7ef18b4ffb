// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace codewheel {

class WindowActions;

// The actions for CAN buses only. All CAN buses of a window share them (WindowActions::ofKind()).
class CanopenActions : public QObject
{
    Q_OBJECT

public:
    explicit CanopenActions(WindowActions &window);

    void tellBus(const QString &bus);                // which bus they apply to; empty: the chosen one
    void tellWhyNotDisconnected(const QString &why); // while it is disabled
    void showChosen(bool isConnected);               // the chosen device: an encoder of a connected CAN bus

    QMenu *menu;
    QAction *settings;
    QAction *search;
    QAction *nodes;
    QAction *training;
    QAction *afresh; // the simulated bus; described by Afresh
    QAction *disconnectBus;
    QAction *remove; // the chosen encoder
};

} // namespace codewheel
