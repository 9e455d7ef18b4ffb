// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/files/dropped_files.h"
#include "app/window/look/late_page.h"
#include "app/window/look/panels.h"
#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "vocabulary/place.h"

#include <QHash>
#include <QMainWindow>

#include <map>
#include <optional>
#include <set>
#include <vector>

class QStackedWidget;

namespace codewheel {

class AlarmStopEverywhere;
class BusAtWork;
class BusViews;
class CamEditor;
class Buses;
class ContextHelp;
class DeviceChoice;
class DevicePanel;
class DialPin;
class DroppedDevice;
class EncoderBus;
struct Fault;
class FaultNotice;
class FinderInWindow;
class InlineMessage;
class Leaving;
class MessageModel;
struct Message;
class MessagesView;
class MonitorArea;
class PageHead;
class ParameterPanel;
class ParameterWizard;
class Plant;
class ProjectDocument;
class ProjectFiles;
class ProjectPage;
class ProjectRecovery;
class RecordingInWindow;
class ReportExport;
class SequenceView;
class Start;
class StatusLine;
class StructureEditor;
class StructureView;
class TraceView;
class TransferPages;
class TrendPage;
class WaitingFile;
struct Track;
class WantedValues;
class WhyInWindow;
class WindowLayouts;
struct WorkInWindow;
class WordChannel;

// The window: menus, tool bar, panels around the open page (monitors, wizard, cams, structure editor,
// comparison), status line. Wires views to the buses and to each other; never handles a word itself. What
// belongs to one kind of bus comes from its BusViews. Constructed empty, so that it is seen at once; attach()
// fills it.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    // The project outlives it: it is kept when the window is rebuilt in another language.
    MainWindow(WindowSettings &settings, ProjectDocument &project, QWidget *parent = nullptr);
    ~MainWindow() override;

    // Both outlive the window: they are kept when it is rebuilt in another language.
    void attach(Plant &plant, MessageModel &messages);
    // At the first start of all: what turns is pinned beside the monitor.
    void showFirstTime();
    // What is under way here, for the window in another language, which goes on with it. This one goes.
    bool mayGo(); // false while values are transferred or a number is given, which it does; it says so
    WorkInWindow takeWork();
    void goOn(WorkInWindow work); // once it is visible
    std::optional<Place> pinnedDial() const;
    void pinDial(Place place); // for this session
    // What has to be known before all else, such as that messages are not kept. Stands until it is closed.
    void warn(const QString &sentence);

    // Takes a frame of the bus and shows it. Called by the FrameClock, in tests by hand.
    void showFrame();
    bool hasJob() const; // on any bus

    const WindowActions &actions() const { return m_actions; }
    RecordingInWindow &recording() { return *m_recording; } // only after attach()
    void showWizard();
    void showMonitors();
    void showCams();
    void showStructureEditor();
    void showComparison(); // of the ring that is chosen, or was chosen last
    void showProjectPage();
    void showTrend();
    void showInTrend(const Track &track);
    bool openRecording(const QString &path); // false: it says why not
    // A project, a recording, cams, a sequence, a fault plan or a device description, as if it were dropped.
    void openFile(const QString &path);
    ProjectFiles &files() { return *m_files; }
    Start &start() { return *m_start; } // only after attach()
    void askForRecovery(ProjectRecovery &recovery);
    void compare();                     // each bus reports how it differs from the project
    BusViews *viewsOf(BusId bus) const; // null: no such bus, or its kind has no views
    void showSettings();                // after they have changed, or for a new window
    // Size, layout and monitors, for the next start.
    void saveWindow();

Q_SIGNALS:
    void firstPainted();
    void languageChosen(const QString &language);
    void appearanceChosen(); // already saved
    void settingsRequested();

protected:
    void closeEvent(QCloseEvent *event) override;
    bool event(QEvent *event) override;

private:
    static constexpr int layoutVersion = 4; // of docks and tool bar: no other version is restored

    void makeDocks(MessageModel &messages);
    void connectActions();
    void connectViewActions();
    void connectViews();
    void connectBuses();      // main_window_buses.cpp
    void connectRecordings(); // main_window_recordings.cpp
    void addViews(BusAtWork &bus, BusViews &views);
    void addBus(BusAtWork *bus);
    void removeBus(BusAtWork *bus);
    void takeBus(BusAtWork &bus);
    void leaveBus(BusAtWork &bus);
    void showWhetherOpen(BusAtWork &bus);
    void showPanel(BusId bus, const Panel &panel);
    // The chosen row, and the device that the panels show: for the row of a bus, the previous device.
    struct Chosen
    {
        std::optional<Place> row;
        std::optional<Place> shown;
    };
    Chosen chosen() const;
    void chooseAgain(const Chosen &before, const BusAtWork &changed);
    void followRow();
    void tellDeviceThatStays();
    void setCurrent(BusAtWork &bus);
    void chooseBus(BusId bus);
    void giveKeys(BusId bus); // those of bus_keys.h
    void showOtherFaults();
    void showFault(BusId bus, const Fault &fault);
    void tellWhose();
    std::optional<Place> recordedEncoder(BusId opened) const;
    void showOneOf(const std::vector<Place> &places);
    void chooseBusOf(Place place);
    void goTo(Place place);        // a device, or without a node a bus
    EncoderBus *chosenBus() const; // null: no bus, or it has no session
    void showChosen();
    void showPageAgain(int page, const QByteArray &kind);
    void makePages();
    CamEditor *makeCams();
    ParameterWizard *makeWizard();
    void makeFinder();
    void connectProject();
    void tell(const Message &message);
    void collectForSupport();
    void showBusState();
    void showStart();
    void foldBottom();
    InlineMessage &addNotice(const QString &name); // above all pages
    void makeWaitingCams();
    void makeWaitingFaultPlan();
    void connectDrops();
    BusViews *takerOfFaultPlans() const; // null: no training ring is connected
    void openDropped(FileKind kind, const QString &path);
    WordChannel *chosenWords() const; // null: no device is chosen, or it has no words
    void showWordActions();
    void operate(EncoderBus &bus);
    void alarmStop();
    std::optional<Place> currentNumber() const;

    WindowSettings &m_settings;
    ProjectDocument &m_project;
    Plant *m_plant = nullptr; // null before attach()
    Buses *m_buses = nullptr;
    std::map<BusId, BusViews *> m_views;
    std::set<BusId> m_shown;           // as connected in the bus structure
    QHash<QString, BusId> m_currentOf; // by kind: which bus its actions and docks apply to
    BusId m_chosenBus = firstBus;      // that of the chosen row
    BusId m_keysOf = firstBus;
    Chosen m_beforeChange; // for a bus that may get the same rows again
    WindowActions m_actions;
    AlarmStopEverywhere *m_alarmStop;
    Leaving *m_leaving;
    StatusLine *m_status;
    WantedValues *m_wanted;
    InlineMessage *m_notice;
    QStackedWidget *m_pages;
    PageHead *m_head;
    ProjectFiles *m_files;
    ContextHelp *m_help;
    FaultNotice *m_faults = nullptr;
    ReportExport *m_report = nullptr;
    RecordingInWindow *m_recording = nullptr;
    StructureEditor *m_editor = nullptr;
    ProjectPage *m_projectPage = nullptr;
    Panels m_panels{*this};
    StructureView *m_structure = nullptr;
    DeviceChoice *m_choice = nullptr;
    MonitorArea *m_monitors = nullptr;
    std::optional<LatePage<CamEditor>> m_cams;
    std::optional<LatePage<ParameterWizard>> m_wizard;
    TrendPage *m_trend = nullptr;
    ParameterPanel *m_parameters = nullptr;
    DialPin *m_dial = nullptr;
    DevicePanel *m_device = nullptr;
    TraceView *m_trace = nullptr;
    SequenceView *m_sequence = nullptr;
    MessageModel *m_messageModel = nullptr;
    MessagesView *m_messages = nullptr;
    TransferPages *m_transfer = nullptr;
    Start *m_start = nullptr;
    FinderInWindow *m_finder = nullptr;
    DroppedDevice *m_droppedDevice = nullptr;
    WaitingFile *m_waitingCams = nullptr;
    WaitingFile *m_waitingFaultPlan = nullptr;
    WhyInWindow *m_why = nullptr;
    bool m_keepsBottomFolded = false; // by the user, whatever is in the middle
    QByteArray m_defaultLayout;
    WindowLayouts *m_layouts = nullptr;
    bool m_painted = false;
    bool m_mayClose = false;
};

} // namespace codewheel
