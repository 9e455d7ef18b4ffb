// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "trend/csv_style.h"
#include "trend/trend_extract.h"
#include "trend/trend_origin.h"
#include "widgets/look/page.h"
#include "widgets/look/printed_view.h"
#include "widgets/look/roles.h"
#include "widgets/trend/encoder_scales.h"
#include "widgets/trend/trend_view.h"

#include <QTimer>

class QAction;
class QBoxLayout;
class QLabel;
class QMenu;
class QStackedWidget;
class QTabBar;
class QTableView;
class QToolBar;

namespace codewheel {

class CurveBar;
class EmptyState;
class InlineMessage;
class NoteBar;
class ShiftBar;
class TrendExport;
class TrendValuesModel;

// The trend: what encoders of any bus have shown, as curves over the time. Sends nothing.
class TrendPage : public Page, public PrintsPicture
{
    Q_OBJECT

public:
    // All outlive it. `station`: of an encoder; empty where it has none.
    TrendPage(Buses &buses, Histories &histories, std::function<QString(Place)> station,
              QWidget *parent = nullptr);

    QString title() const override { return tr("Trend"); }
    QString effect() const override;
    std::optional<PrintedView> printedView() const override;

    TrendTracks &tracks() { return m_tracks; }
    TrendView &view() { return *m_view; }
    // Beside the line about what is kept: a button for something that keeps it for longer.
    void addButtonFor(QAction &action);
    // Shows this curve beside those that are there.
    void showTrack(const Track &track);
    // Now all of it, also what otherwise waits until the cursors rest or some frames have passed.
    void bringUpToDate();
    void showFrame(); // while it is visible, with each frame of the window

    // What of the time is exported.
    enum class Extract : std::uint8_t { seen, betweenCursors, all };

    // Both report on the spot what went wrong. The table is written piece by piece.
    bool savePicture(const QString &path); // by its suffix: .svg, or else as PNG
    void exportTo(const QString &path, Extract what);

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void makeTools();
    void makeTable();
    void makeShortcuts();
    void connectParts();
    void connectRecordings();
    void showWhatThereIs();
    void showCurve();
    void takeArchives();
    void beginTogether();
    void layTogether();
    std::vector<Track> tracksOfRecordings() const;
    void putCursorAOnB();
    void showValues();
    void showStatistics();
    void showColumns();
    void giveTableRoom();
    void showCursors();
    void showMemory();
    void showMark(bool forward);
    void askNote();
    QMenu *makeExportMenu();
    void askPicture();
    void askExport(Extract what);
    std::optional<TimeSpan> spanOf(Extract what) const;
    TrendColumn columnOf(const TrendTracks::Shown &shown) const;
    CsvStyle csvStyle() const;
    TrendOrigin origin() const;
    void endExport(const QString &failure);
    void cancelExport();
    void say(Role role, const QString &sentence, const QString &action = {});
    void sayNotWritten(const QString &path, const QString &why);
    QString markAtCursor() const;
    std::optional<std::size_t> currentCurve() const;

    Buses &m_buses;
    Histories &m_histories;
    std::function<QString(Place)> m_station;
    TrendTracks m_tracks;
    EncoderScales m_scales;
    QStackedWidget *m_pages;
    EmptyState *m_empty;
    QToolBar *m_tools;
    InlineMessage *m_message;
    TrendView *m_view;
    NoteBar *m_note;
    QLabel *m_cursors;
    QTabBar *m_parts;
    TrendValuesModel *m_values;
    QTableView *m_table;
    CurveBar *m_curve;
    ShiftBar *m_shift; // of the recording that the chosen curve is of
    QLabel *m_memory;
    QBoxLayout *m_lastLine = nullptr;
    QAction *m_follow = nullptr;
    QAction *m_pause = nullptr;
    QAction *m_together = nullptr; // with two recordings or more
    QAction *m_forSpreadsheets = nullptr;
    QAction *m_withDates = nullptr;
    TrendExport *m_export = nullptr; // while it is written
    int m_percent = -1;
    QTimer m_soon;   // showStatistics()
    QTimer m_seldom; // what need not be right in each frame
};

} // namespace codewheel
