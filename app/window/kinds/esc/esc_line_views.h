// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"
#include "app/window/buses/bus_views.h"
#include "app/window/kinds/esc/esc_line_status.h"
#include "kinds/esc/line/esc_line_scan.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "vocabulary/refusal.h"
#include "widgets/help/key_help.h"

#include <QPointer>

#include <array>

namespace codewheel {

class ConnectPage;
class ComparisonPage;
class EscLineActions;
class EscLineKeeper;
class EscLinePanel;
class EscLineSearch;
class EscLineSession;
class EscLineSettingsForm;
class EscLineTerminal;
class EscLineTrainingPanel;
class OperateQuestion;
class EscLineAtWork;
struct EscLineSettings;

inline constexpr Panel terminalPanel{"terminalDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Line terminal"),
                                     Qt::ALT | Qt::Key_0, "serial-line.md#the-terminal",
                                     Panel::Behind::messages};
inline constexpr Panel linePanel{"lineDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Serial line"),
                                 Qt::ALT | Qt::SHIFT | Qt::Key_L, "serial-line.md#the-panel",
                                 Panel::Behind::state};
inline constexpr std::array linePanels{&terminalPanel, &linePanel};
KeyGroup keysOfLines(); // that no action has

// The views of a serial line in the window: terminal and panel, which are in docks, the pages for connecting
// it and searching for encoders, and the actions that open them.
class EscLineViews final : public BusViews
{
    Q_OBJECT

public:
    EscLineViews(EscLineAtWork &line, const WindowParts &parts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override;
    QWidget *comparison() const override;
    QMenu *menu() const override;
    void setChosen(std::optional<Place> place) override;
    void setRecordingChosen(bool isChosen) override;
    void open() override;
    bool open(Place place) override; // its terminal, since it has no words
    void connectBus() override { showSettings(); }
    void connectTraining() override;
    void connectFound(const KindData &plan, const std::vector<KindData> &devices) override;
    void showFrame() override;
    void askToOperate(const std::function<void()> &then) override;
    void useSettings(const ProgramSettings &settings) override;
    std::any takeWork() override;
    void goOn(const std::any &work) override;
    FaultBanner::Offer offer(const Fault &fault, FaultAction action) const override;
    void act(const Fault &fault, FaultAction action) override;
    QAction *actionFor(DataCheck::Action action) const override;

    void showSettings();
    void showSearch();

private:
    void showCurrent() override;
    void showStatus();
    void showTerminal();
    void determineFractionBits();
    // Stops polling the chosen encoder and, unless it is on the training line, removes it from the project.
    void removeChosen();
    // From now on its warnings are read with their two bytes swapped, or as they come.
    void swapWarningBytes(bool on);
    void setLine(EscLineSession *line); // null: it is about to go
    void showFound();
    void listPorts();
    EscLinePlan wanted(const EscLineSettings &wish) const;
    void connectAs(const KindData &plan);
    void test(const KindData &plan);
    void connectOtherAdapter(const KindData &plan);
    void showOpened();
    void showRefused(const Refusal &why);
    void keepPort(const EscLinePlan &line);
    void showState();
    void startAfresh();
    void disconnectLine();
    void takeOver(const std::vector<FoundEncoder> &found, const QString &deviceKey);
    void askForOtherAdapter(const Refusal &which);
    void useOtherAdapter();
    void takeFractionBits(const Result<int> &bits);
    void watchBaudRates();
    void tellBaudRate(Place encoder, int rate);
    void explainTerminal();
    void tellActions();
    void showChosen();
    void showActions();
    void showPlanned();
    void showNewPlan();
    void showName();

    EscLineAtWork &m_line;
    const WindowParts m_parts;
    EscLineActions &m_actions;
    EscLineStatus m_status;
    InlineMessage *m_notice; // asks about an adapter
    EscLineKeeper *m_keeper;
    OperateQuestion *m_operateQuestion;
    QPointer<EscLineSession> m_session;
    std::optional<Place> m_chosen;
    bool m_takesOther = false; // keep another adapter once it is open
    EscLineTerminal *m_terminal;
    EscLinePanel *m_panel;
    ConnectPage *m_connection;
    EscLineSettingsForm *m_form;
    EscLineSearch *m_search;
    EscLineTrainingPanel *m_training;
    BackgroundSteps m_test;
    bool m_isPlanned = false; // in the project
    bool m_isFound = false;   // its port, by the finder
    std::vector<FoundEncoder> m_foundThere;
    EscLinePlan m_opened; // when a port was last to be opened
    ComparisonPage *m_comparison;
};

} // namespace codewheel
