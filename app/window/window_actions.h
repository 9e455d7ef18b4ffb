// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QStringList>

#include <map>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QToolBar;
class QUndoStack;

namespace codewheel {

class ModeSwitch;
class ShownEncoder;
class WordChannel;

// Every action of the main window, with text, icon, tooltip and key, in menus and tool bar. MainWindow
// connects them to whatever carries them out.
class WindowActions : public QObject
{
    Q_OBJECT

public:
    // The undo steps are those of the project.
    WindowActions(QMainWindow &window, QUndoStack &undoStack);

    // Places for the actions of a kind of bus: before Watch, after Start and Stop, and before ALARM STOP in
    // the bus menu; at the end of the device menu; in the tool bar.
    enum class Section : std::uint8_t { connections, services, kinds, device, toolBar };
    void insert(Section where, const QList<QAction *> &actions);
    QWidget *menuParent() const;
    // Those of a kind, created with its first bus.
    template <class Actions>
    Actions &ofKind()
    {
        auto *its = findChild<Actions *>(QString(), Qt::FindDirectChildrenOnly);
        return its != nullptr ? *its : *new Actions(*this);
    }

    // Says why the chosen device cannot be set up, or has no cams.
    void showChosen(const ShownEncoder &encoder);
    // Its words can be viewed if its bus is open; null: it has none.
    void showWords(const ShownEncoder &encoder, const WordChannel *words, bool isOpen);
    void showTrace(bool isThere);
    // The bus that Watch and Operate apply to; empty: there is only one it could be.
    void tellMode(const QString &bus);
    // The names of the buses it acts on, and what it does there.
    void showAlarmStop(const QStringList &buses, const QStringList &effects);

    // File
    QAction *newProject;
    QAction *openProject;
    QMenu *recentFiles;
    QAction *openRecording;
    QAction *closeRecording;
    QAction *saveProject;
    QAction *saveProjectAs;
    QAction *projectPage;
    QAction *exportReport;
    QAction *print;
    QAction *record;
    QAction *exportTrace;
    QAction *exportMessages;
    QAction *quit;
    // Edit
    QAction *undo;
    QAction *redo;
    QAction *structureEditor;
    QAction *compare;
    QAction *settings;
    // Bus
    QAction *findEncoders;
    QAction *watch;
    QAction *operate;
    QAction *start;
    QAction *stop;
    QAction *alarmStop;
    QAction *transfer;
    // Device
    QAction *openMonitor;
    QAction *pinMonitor;
    QAction *pinDial;
    QAction *showInTrend;
    QAction *wizard;
    QAction *cams;
    QAction *replaceEncoder;
    QAction *restoreValues;
    QAction *whyNoData;
    QAction *zeroOut;
    // View
    QMenu *docks;
    QAction *monitors;
    QAction *trend;
    QAction *closePage;
    QAction *largeControls;
    QAction *lessMotion;
    QActionGroup *scheme;   // data(): int(Scheme)
    QActionGroup *language; // data(): QString, empty for the system's
    QAction *foldBottom;
    QAction *defaultLayout;
    // Help
    QAction *findCommand; // enabled with the palette
    QAction *help;        // about what has the focus
    QAction *manual;      // at its first page
    QAction *keys;
    QAction *collectSupport;
    QAction *about;

    QMenu *deviceMenu;

private:
    QMenu *addMenu(const QString &title);
    void makeFileMenu();
    void makeEditMenu(QUndoStack &undoStack);
    void makeBusMenu();
    void makeDeviceMenu();
    void makeViewMenu();
    void makeHelpMenu();
    void makePages();
    void makeToolBar();
    QList<QAction *> pages() const;
    static QString shortName(const QString &bus);
    static void showFocusOf(QToolBar &bar);

    struct Spot
    {
        QWidget *menu = nullptr;
        QAction *before = nullptr; // null: at the end
    };

    QMainWindow &m_window;
    ModeSwitch *m_mode = nullptr;
    std::map<Section, Spot> m_sections;
};

} // namespace codewheel
