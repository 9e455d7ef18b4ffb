// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "widgets/monitor/monitor_display.h"

#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace codewheel {

class EmptyState;
class WordCard;
struct Track;

// The column of monitors: that of the chosen device, which follows the choice, above the pinned ones.
class MonitorArea : public QWidget
{
    Q_OBJECT

public:
    explicit MonitorArea(Buses &buses, QWidget *parent = nullptr);

    // Gives the name of a device at the plant.
    void setStations(std::function<QString(Place)> stationOf);
    void showStations(); // after they may have changed

    // The chosen device: its monitor opens, unless it is already pinned or was closed since.
    void follow(std::optional<Place> chosen);
    // Brings its monitor into view, with the focus on its bits; that of a device other than the chosen one is
    // pinned.
    void open(Place place);
    void pin(Place place);
    void close(Place place);
    void closeAll();
    WordCard *card(Place place) const; // null: not open
    const std::vector<WordCard *> &cards() const { return m_cards; }

    // Which monitors are pinned, and what they all show; saved by the window.
    QJsonObject state() const;
    // Also accepts older states: a monitor per word, all of them pinned.
    void restoreState(const QJsonObject &state);

Q_SIGNALS:
    void trendWanted(const codewheel::Track &track);

protected:
    // A device dragged out of the bus structure is pinned.
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    bool canShow(Place place) const;
    QString whyNot(Place place) const;
    WordCard *find(bool pinned, Place place) const;
    WordCard *add(Place place, bool pinned);
    WordCard *make(Place place);
    void makeAnew(WordCard *card);
    void remove(WordCard *card);
    void notePinned(Place place, bool pinned);
    void setPinned(WordCard *card, bool pinned);
    void closed(WordCard *card);
    void setDisplay(const MonitorDisplay &display);
    void followDevices();
    void bringBack();
    void showFollowing();
    void showFrame(BusId bus);
    void showWhatThereIs();

    Buses &m_buses;
    std::function<QString(Place)> m_stationOf;
    QStackedWidget *m_pages;
    EmptyState *m_empty;
    QScrollArea *m_scroll;
    QVBoxLayout *m_column;
    QLabel *m_note;                  // why the chosen device has none
    std::vector<WordCard *> m_cards; // from top to bottom: the one that follows first
    std::vector<Place> m_pinned;     // including buses that are not open: they come back with them
    std::optional<Place> m_chosen;
    bool m_isClosed = false; // the one that follows, by the user
    MonitorDisplay m_display;
};

} // namespace codewheel
