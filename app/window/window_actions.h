// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <vector>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QUndoStack;

namespace codewheel {

class ShownEncoder;

// Everything that can be asked for in the main window, with text, icon, tooltip and key, in menus and tool
// bar. Who carries it out is connected by MainWindow.
class WindowActions : public QObject
{
    Q_OBJECT

public:
    // The steps of undo are those of the project.
    WindowActions(QMainWindow &window, QUndoStack &undoStack);

    // Says of the device that is chosen why it cannot be set up, has no cams, or cannot be sent
    // anything.
    void showChosen(const ShownEncoder &encoder);
    // On which buses it acts, by their names.
    void showAlarmStop(const QStringList &buses);

    // File
    QAction *newProject;
    QAction *openProject;
    QMenu *recentFiles;
    QAction *saveProject;
    QAction *saveProjectAs;
    QAction *projectPage;
    QAction *exportReport;
    QAction *exportTrace;
    QAction *exportMessages;
    QAction *quit;
    // Edit
    QAction *undo;
    QAction *redo;
    QAction *structureEditor;
    QAction *compare;
    // Bus
    QAction *connectBus;
    QAction *disconnectBus;
    QAction *readIn;
    QAction *watch;
    QAction *operate;
    QAction *start;
    QAction *stop;
    QAction *confirmDiagnostics;
    QAction *switchSegment; // of the chosen device
    QAction *alarmStop;
    QAction *transfer;
    QMenu *lineMenu; // the serial line
    QAction *lineSettings;
    QAction *lineSearch;
    QAction *lineTerminal;
    QAction *linePanel;
    QAction *lineTraining;
    QAction *disconnectLine;
    // Device
    QAction *openIn32;
    QAction *openOut32;
    QAction *openIn16;
    QAction *wizard;
    QAction *cams;
    QAction *replaceEncoder;
    QAction *restoreValues;
    QAction *zeroOut;
    QAction *swapWarningBytes; // checkable
    QAction *removeFromLine;
    // View
    QMenu *docks;
    QAction *monitors;
    QAction *largeControls;
    QAction *lessMotion;
    QActionGroup *scheme;   // data(): int(Scheme)
    QActionGroup *language; // data(): QString, empty for the system's
    QAction *defaultLayout;
    // Help
    QAction *keys;
    QAction *about;

    QMenu *deviceMenu;

private:
    void makeFileMenu();
    void makeEditMenu(QUndoStack &undoStack);
    void makeBusMenu();
    void makeLineMenu(QMenu &busMenu);
    void makeDeviceMenu();
    void makeViewMenu();
    void makeHelpMenu();
    void makeToolBar();

    QMainWindow &m_window;
};

} // namespace codewheel
