// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "encoder/refusal.h"
#include "line/line_scan.h"

#include <QObject>
#include <QPointer>

class QStackedWidget;
class QWidget;

namespace codewheel {

class InlineMessage;
class Leaving;
class LineKeeper;
class LinePanel;
class LineSearch;
class LineSession;
class LineSettingsForm;
class LineTerminal;
class ProjectDocument;
class SerialLine;
class WindowActions;
class WindowSettings;
struct LineWish;
struct Message;
struct LinePlan;

// The views of the serial line in the window: terminal and panel, which stand in docks, and the pages to
// connect it and to search for encoders; and the actions that open them.
class LineViews : public QObject
{
    Q_OBJECT

public:
    // All must outlive it; the pages are put into `pages`. The notice stands in the window: what is asked of
    // an adapter.
    LineViews(SerialLine &line, ProjectDocument &project, WindowSettings &settings, Leaving &leaving,
              const WindowActions &actions, QStackedWidget &pages, InlineMessage &notice);
    ~LineViews() override;

    LineTerminal &terminal() { return *m_terminal; }
    LinePanel &panel() { return *m_panel; }

    void showSettings();
    void showSearch();
    // Null: the line is about to go.
    void setLine(LineSession *line);
    // Asks the chosen encoder for the format of its scaling factor, or else the first that answers.
    void determineFractionBits(std::optional<Place> chosen);
    // Takes the encoder out of polling and, unless it is one of the training line, out of the project.
    void remove(Place number);
    // From now on its warnings are read with their two bytes in the other order, or as they come.
    void swapWarningBytes(Place number, bool on);

Q_SIGNALS:
    void portConnected(); // it begins in Watch
    void terminalRequested();
    void panelRequested();
    void removalRequested(); // of the chosen encoder
    void fractionBitsRequested();
    void warningBytesRequested(bool swapped); // of the chosen encoder

private:
    void listPorts();
    void connectPort(const LineWish &wish, bool isPicked);
    void connectOtherAdapter(const LineWish &wish);
    void showConnected(const Result<void> &opened, const LinePlan &wanted);
    void keepPort(const LinePlan &line);
    void showState();
    void connectTraining();
    void disconnectLine();
    void takeOver(const std::vector<FoundEncoder> &found, const QString &deviceKey);
    void askForOtherAdapter(const Refusal &which);
    void useOtherAdapter();
    void takeFractionBits(const Result<int> &bits);
    void tellBaudRate(const Message &message);
    void explainTerminal();
    void showActions();
    void showWish();

    SerialLine &m_line;
    ProjectDocument &m_project;
    Leaving &m_leaving;
    const WindowActions &m_actions;
    QStackedWidget &m_pages;
    InlineMessage &m_notice;
    LineKeeper *m_keeper;
    QPointer<LineSession> m_session;
    bool m_takesOther = false; // another adapter, once it is open
    LineTerminal *m_terminal;
    LinePanel *m_panel;
    LineSettingsForm *m_form;
    LineSearch *m_search;
};

} // namespace codewheel
