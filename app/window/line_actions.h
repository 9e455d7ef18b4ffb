// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace codewheel {

class WindowActions;

// What can be asked for of a serial line alone. All lines of a window share them (WindowActions::ofKind()).
class LineActions : public QObject
{
    Q_OBJECT

public:
    explicit LineActions(WindowActions &window);

    // Of the device that is chosen: whether it is an encoder of a line, connected, and one that sends the low
    // byte of its warnings first.
    struct Chosen
    {
        bool isOnLine = false;
        bool isConnected = false;
        bool isSwapped = false;
    };
    void showChosen(Chosen chosen);
    void tellBus(const QString &bus); // which line they mean; empty: the chosen one

    QMenu *menu;
    QAction *settings;
    QAction *search;
    QAction *terminal;
    QAction *figures;
    QAction *training;
    QAction *disconnectLine;
    // Of the chosen encoder
    QAction *swapWarningBytes; // checkable
    QAction *remove;
};

} // namespace codewheel
