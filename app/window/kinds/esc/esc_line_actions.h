// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace codewheel {

class WindowActions;

// The actions for serial lines only. All lines of a window share them (WindowActions::ofKind()).
class EscLineActions : public QObject
{
    Q_OBJECT

public:
    explicit EscLineActions(WindowActions &window);

    // The chosen device: whether it is an encoder on a line, connected, and sends the low byte of its
    // warnings first.
    struct Chosen
    {
        bool isOnLine = false;
        bool isConnected = false;
        bool isSwapped = false;
    };
    void showChosen(Chosen chosen);
    void tellBus(const QString &bus);                // which line they apply to; empty: the chosen one
    void tellWhyNotDisconnected(const QString &why); // while it is disabled

    QMenu *menu;
    QAction *settings;
    QAction *search;
    QAction *terminal;
    QAction *figures;
    QAction *training;
    QAction *afresh; // the training line; described by Afresh
    QAction *disconnectLine;
    // For the chosen encoder
    QAction *swapWarningBytes; // checkable
    QAction *remove;
};

} // namespace codewheel
