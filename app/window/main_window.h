// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "encoder/place.h"

#include <QJsonObject>
#include <QMainWindow>

#include <memory>
#include <optional>
#include <vector>

class QDockWidget;
class QStackedWidget;

namespace codewheel {

class AlarmStopEverywhere;
class BusSession;
class CamEditor;
class ComparisonPage;
class Buses;
class DeviceChoice;
class DevicePanel;
class DialPanel;
class InlineMessage;
class LastPositions;
class Leaving;
class LineViews;
class LedgerKeeper;
class MasterPanel;
class MessageModel;
struct Message;
class MessagesView;
class MonitorArea;
class ParameterPanel;
class ParameterWizard;
class ProjectDocument;
class ProjectFiles;
class ProjectPage;
class ProjectRecovery;
class ReportExport;
class RingConnection;
class SequenceView;
class SerialLine;
class StatusLine;
class StructureEditor;
class StructureView;
class TraceView;
class TrainingControls;
class TrainingPanel;
class TransferPages;
class WantedValues;

// The window: menus, tool bar, panels around the page that is open (monitors, wizard, cams, structure editor,
// comparison), status line. Wires
// views to the bus session and to each other; does nothing of its own with a word. Made empty, so that it is
// seen at once; attach() fills it.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    // The project outlives it: it is kept when the window is made anew in another language.
    MainWindow(WindowSettings &settings, ProjectDocument &project, QWidget *parent = nullptr);
    ~MainWindow() override;

    // What the window looks at. All of it outlives the window: it is kept when the window is made anew in
    // another language.
    struct Plant
    {
        BusSession &bus;
        QString link; // its name in the status line
        std::shared_ptr<TrainingControls> training;
        SerialLine &line;
        MessageModel &messages;
        const LedgerKeeper &ledger; // of the EEPROM writes of its encoders
        const LastPositions &positions;
    };
    void attach(const Plant &plant);
    // What has to be known before all else, such as that messages are not kept. Stands until it is closed.
    void warn(const QString &sentence);

    // Takes a picture of the bus and shows it. Called by the PictureClock, by hand in tests.
    void showPicture();
    bool hasJob() const; // on any bus

    const WindowActions &actions() const { return m_actions; }
    void showWizard();
    void showMonitors();
    void showCams();
    void showStructureEditor();
    void showComparison();
    void showProjectPage();
    ProjectFiles &files() { return *m_files; }
    void askForRecovery(ProjectRecovery &recovery);
    RingConnection *connection() { return m_connection; } // null before attach()
    // Size, layout and monitors, for the next start.
    void saveWindow();

Q_SIGNALS:
    void firstPainted();
    void languageChosen(const QString &language);

protected:
    void closeEvent(QCloseEvent *event) override;
    bool event(QEvent *event) override;

private:
    static constexpr int layoutVersion = 3; // of docks and tool bar: another one is not restored

    void makeDocks(MessageModel &messages);
    void addDock(const char *name, const QString &title, QWidget *content, const QKeySequence &key);
    void showDock(const char *name);
    void connectActions();
    void connectViewActions();
    void connectViews();
    void makeLineViews(); // main_window_line.cpp
    void connectLine();
    void makeRoomForTerminal();
    void leaveLine();
    void showLine();
    void showChosen();
    void showOtherRing();
    void openFirstMonitors();
    void makePages();
    void connectProject();
    void showOnline();
    void tell(const Message &message);
    void showBusState();
    void setOperate(bool on);
    void alarmStop();
    std::optional<Place> currentNumber() const;

    WindowSettings &m_settings;
    ProjectDocument &m_project;
    BusSession *m_bus = nullptr;
    SerialLine *m_line = nullptr;
    Buses *m_buses = nullptr;
    LineViews *m_lineViews = nullptr;
    std::shared_ptr<TrainingControls> m_training;
    WindowActions m_actions;
    AlarmStopEverywhere *m_alarmStop;
    Leaving *m_leaving;
    StatusLine *m_status;
    WantedValues *m_wanted;
    InlineMessage *m_notice;
    QStackedWidget *m_pages;
    ProjectFiles *m_files;
    RingConnection *m_connection = nullptr;
    ReportExport *m_report = nullptr;
    QString m_link;
    const LedgerKeeper *m_ledger = nullptr;
    const LastPositions *m_positions = nullptr;
    QJsonObject m_openMonitors; // while offline
    StructureEditor *m_editor = nullptr;
    ComparisonPage *m_comparison = nullptr;
    ProjectPage *m_projectPage = nullptr;
    std::vector<QDockWidget *> m_docks;
    StructureView *m_structure = nullptr;
    DeviceChoice *m_choice = nullptr;
    MonitorArea *m_monitors = nullptr;
    ParameterWizard *m_wizard = nullptr;
    CamEditor *m_cams = nullptr;
    ParameterPanel *m_parameters = nullptr;
    DialPanel *m_dial = nullptr;
    DevicePanel *m_device = nullptr;
    TraceView *m_trace = nullptr;
    SequenceView *m_sequence = nullptr;
    MessageModel *m_messageModel = nullptr;
    MessagesView *m_messages = nullptr;
    MasterPanel *m_master = nullptr;
    TrainingPanel *m_trainingPanel = nullptr;
    TransferPages *m_transfer = nullptr;
    QByteArray m_defaultLayout;
    bool m_painted = false;
    bool m_mayClose = false;
};

} // namespace codewheel
