// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "widgets/monitor/monitor_display.h"
#include "widgets/monitor/monitor_kind.h"

#include <QMap>
#include <QWidget>

class QMenu;
class QScrollArea;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace codewheel {

class InlineMessage;
class WordMonitor;

// The column of monitors: as many as wanted, each pinned to a device and to IN 32, OUT 32 or IN 16.
class MonitorArea : public QWidget
{
    Q_OBJECT

public:
    explicit MonitorArea(Buses &buses, QWidget *parent = nullptr);

    // Opens it at the end, or brings it into view where it is open already; says on the spot why it cannot.
    void openMonitor(Place number, MonitorKind kind);
    // All words the device has: IN 32, or IN 16 where there is no more, and OUT 32.
    void openWords(Place number);
    // At first start: IN 32 and OUT 32 of the first device that has both.
    void openFirst();
    void closeMonitor(Place number, MonitorKind kind);
    void closeAll();
    WordMonitor *monitor(Place number, MonitorKind kind) const; // null: not open
    const std::vector<WordMonitor *> &monitors() const { return m_monitors; }

    // Which monitors are open, and what each kind shows; for the window to keep.
    QJsonObject state() const;
    // Devices that an open bus does not have any more are left out.
    void restoreState(const QJsonObject &state);

private:
    void makeBar();
    void openAgain(Place number);
    void followDevices();
    void fillAddMenu();
    WordMonitor *addMonitor(Place number, MonitorKind kind);
    void remove(WordMonitor *monitor);
    QString whyNot(Place number, MonitorKind kind) const;
    bool hasWord(Place number, MonitorKind kind) const;
    void setDisplay(MonitorKind kind, const MonitorDisplay &display);
    void showPicture(BusId bus);
    void putAside();
    void bringBack();
    void showWhetherEmpty();

    // Of a bus that is not open: they come back with it.
    struct Aside
    {
        Place place;
        MonitorKind kind;
        bool isHighHalf;
    };

    Buses &m_buses;
    QToolButton *m_add;
    QMenu *m_addMenu;
    InlineMessage *m_message;
    QStackedWidget *m_pages;
    QScrollArea *m_scroll;
    QVBoxLayout *m_column;
    std::vector<WordMonitor *> m_monitors; // from top to bottom
    std::vector<Aside> m_aside;
    QMap<MonitorKind, MonitorDisplay> m_displays;
};

} // namespace codewheel
