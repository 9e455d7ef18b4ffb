// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "vocabulary/place.h"
#include "widgets/monitor/word_format.h"

#include <QPointer>
#include <QWidget>

#include <map>
#include <optional>

class QAction;
class QLabel;
class QStackedWidget;
class QToolBar;

namespace codewheel {

class EmptyState;
class GoToPlace;
class InlineMessage;
class IconCells;
class LogTable;
class TrafficModel;

// The handshake trace: one row per change of the selected encoder's words, as printed in the manuals, or what
// else its bus reports for it alone. It collects for all encoders, selected or not.
class TraceView : public QWidget
{
    Q_OBJECT

public:
    explicit TraceView(Buses &buses, QWidget *parent = nullptr);
    ~TraceView() override;

    // Null: an empty state, which says so if the chosen encoder is not connected.
    void setEncoder(codewheel::EncoderSession *encoder, std::optional<codewheel::Place> offline = {});
    void setMostRows(int rows);                         // of each encoder
    bool hasRows() const { return m_shown != nullptr; } // a trace is shown, even an empty one
    std::vector<Place> places() const;                  // for which something was collected
    std::vector<Word>
    outWords(Place place) const;             // that it has, oldest first, without what stood there at first
    TrafficModel *model(Place number) const; // null: nothing was collected for it

    // What was collected, for the view in another language.
    struct Collected
    {
        DeviceDescription device;
        std::unique_ptr<TrafficModel> rows{};
        QPointer<EncoderBus> bus{}; // null: its connection has ended
    };
    using Traces = std::map<Place, Collected>;
    Traces takeTraces();
    void goOn(Traces traces);

    // UTF-8, comma-separated (docs/manual/sequence-and-trace.md). Reports on the spot what went wrong.
    bool exportTo(const QString &path);
    void exportRows(); // asks for the file

Q_SIGNALS:
    void terminalRequested(); // which shows the traffic of a serial line
    void goToWanted(codewheel::Place place);

private:
    // Sessions come and go with the connection; a trace stays as long as the device is the same.
    void watchEncoders();
    void collect(const EncoderSession &encoder);
    void keep(Place place, Collected fresh);
    void add(const TrafficRow &row);
    void beginAnew(); // of the bus that says so
    void makeTable();
    void makeTools();
    bool hasTerminal(const EncoderSession &encoder) const;
    void showWhyEmpty(const EncoderSession *encoder, std::optional<Place> offline);
    void showModel();
    void setUpColumn(int column);
    void makeRoom(int first, int last); // for these rows
    void showCounts();
    int meaningColumn() const;
    const std::pair<const Place, Collected> &shown() const; // whose rows are m_shown
    std::vector<int> chosenRows() const;                    // selected, or all
    void copy();
    void copyWords(WordNotation notation); // OUT and IN

    Buses &m_buses;
    Traces m_collected;
    TrafficModel *m_shown = nullptr;
    int m_mostRows = 20'000;
    QStackedWidget *m_pages;
    EmptyState *m_empty;
    QToolBar *m_tools;
    QAction *m_hold = nullptr;
    QAction *m_bringBack = nullptr;
    GoToPlace *m_goTo;
    LogTable *m_table;
    IconCells *m_icons;
    QLabel *m_counts;
    InlineMessage *m_message;
};

} // namespace codewheel
