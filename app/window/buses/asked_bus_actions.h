// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/icons.h"

#include <QKeySequence>
#include <QObject>

class QAction;
class QMenu;

namespace codewheel {

class WindowActions;

// The menu of a kind of bus whose encoders are asked, and what each of them has in it. A kind adds its own.
class AskedBusActions : public QObject
{
    Q_OBJECT

public:
    void tellBus(const QString &bus);                // which bus they apply to; empty: the chosen one
    void tellWhyNotDisconnected(const QString &why); // while it is disabled
    void setHasKeys(bool has);                       // those of bus_keys.h, besides its own

    QMenu *menu;
    QAction *settings = nullptr;
    QAction *search = nullptr;
    QAction *training = nullptr;
    QAction *afresh = nullptr; // the simulated bus; described by Afresh
    QAction *disconnectBus = nullptr;
    QAction *remove = nullptr; // the chosen encoder

protected:
    AskedBusActions(WindowActions &window, const QString &title);

    QAction *add(Icon icon, const QString &text, const QKeySequence &key, const QString &what);
    void addAfresh();
};

} // namespace codewheel
