// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_views.h"
#include "kinds/canopen/protocol/nmt.h"
#include "vocabulary/refusal.h"

#include <QPointer>

#include <array>
#include <optional>

class QMessageBox;

namespace codewheel {

class CanBusPanel;
class CanSearchPage;
class CanSettingsForm;
class CanTrafficView;
class CanTrainingPanel;
class CanopenActions;
class CanopenAtWork;
class CanopenKeeper;
class CanopenSession;
class DictionaryView;
class NodeRecognition;
class NodeSetupPage;
class PagePlace;
class SetupsUnderWay;
struct CanFoundRow;
struct FrameSent;
struct Outcome;

inline constexpr Panel canTrafficPanel{"canTrafficDock",
                                       QT_TRANSLATE_NOOP("codewheel::Panels", "CAN traffic"),
                                       Qt::ALT | Qt::SHIFT | Qt::Key_T,
                                       "canopen.md#the-traffic",
                                       Panel::Behind::messages,
                                       false};
inline constexpr Panel canBusPanel{"canBusDock",
                                   QT_TRANSLATE_NOOP("codewheel::Panels", "CAN bus"),
                                   Qt::ALT | Qt::SHIFT | Qt::Key_N,
                                   "canopen.md#the-panel",
                                   Panel::Behind::state,
                                   false};
inline constexpr Panel canObjectsPanel{"canObjectsDock",
                                       QT_TRANSLATE_NOOP("codewheel::Panels", "Objects"),
                                       Qt::ALT | Qt::SHIFT | Qt::Key_D,
                                       "canopen.md#objects",
                                       Panel::Behind::messages,
                                       false};
inline constexpr std::array canPanels{&canTrafficPanel, &canBusPanel, &canObjectsPanel};

// The views of a CAN bus in the window: nodes, objects and traffic, which are in docks, the pages for
// connecting it and searching for nodes, and the actions that open them.
class CanopenViews final : public AskedBusViews
{
    Q_OBJECT

public:
    CanopenViews(CanopenAtWork &bus, const WindowParts &windowParts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override;
    void setChosen(std::optional<Place> place) override;
    void setRecordingChosen(bool isChosen) override;
    void open() override;
    bool open(Place place) override; // its row among the nodes, since it has no words
    void connectFound(const KindData &plan, const std::vector<KindData> &devices) override;
    void useSettings(const ProgramSettings &settings) override;
    void showFrame() override;
    bool isWriting() const override;
    std::optional<WorkUnderWay> underWay() const override;
    void breakOff(const std::function<void(bool isSettled)> &then) override;
    ReplaceStepsOfKind replaceSteps(Replacing &replacing) override;
    QAction *actionFor(DataCheck::Action action) const override;

    void showSetup(std::optional<int> node); // empty: of a device without a number, to be found

private:
    // What the bar above the pages asks the user to agree to.
    enum class Asked : std::uint8_t {
        nothing,
        unsureWatch, // that watching may acknowledge frames
        otherMaster, // that frames are sent beside another master
        onlyJ1939,   // that frames are sent to whoever speaks J1939
        stopOfNode,  // that a job stops its node for a moment
    };

    // Made once the bus is connected, or one of them is shown.
    struct Made
    {
        CanTrafficView *traffic;
        CanBusPanel *panel;
        DictionaryView *objects;
        NodeSetupPage *setup;
    };
    struct Places
    {
        PagePlace *traffic;
        PagePlace *panel;
        PagePlace *objects;
        PagePlace *setup;
    };

    PagePlace *makePlace();
    Made &made();
    void connectMade();
    void tellBus();
    CanopenSession *session() const;
    void setBus(AskedBus *bus) override;
    TrainingArea *training() const override;
    ShownStatus status() const override;
    void listPorts() override;
    void test(const KindData &plan) override;
    void jobEnded(const EncoderSession &encoder, const Outcome &outcome) override;
    void showSimulated() override { open(); }
    void showChosen() override;
    void agree(); // to what the notice asks
    std::any takeRows() override;
    void showRows(const std::any &rows) override;
    void showState();
    void ask(Asked what, const QString &sentence, const QString &answer);
    void withdraw(Asked what);
    void askToCommand(int node, canopen::NmtCommand command);
    void sendCommand(int node, canopen::NmtCommand command);
    void tellSent(const FrameSent &sent);
    void takeOver(const std::vector<CanFoundRow> &found);
    void showPlannedObjects();
    void tellRecognised(Place place, const QString &device);
    void takeNumbered(int before, int after);

    CanopenAtWork &m_bus;
    CanopenActions &m_actions;
    Asked m_asked = Asked::nothing;
    CanopenKeeper *m_keeper;
    std::optional<Place> m_wouldStop; // the node that a job asks to stop
    QPointer<QMessageBox> m_commandQuestion;
    QAction *m_startNode; // the chosen one, after the question
    NodeRecognition *m_recognition;
    CanSearchPage *m_search;
    Places m_places;
    std::optional<Made> m_made;
    bool m_isRecordingChosen = false;
    CanTrainingPanel *m_training;
    SetupsUnderWay *m_setups;
    CanSettingsForm *m_interface;
    CanSettingsForm *m_adapter; // at a serial port
};

} // namespace codewheel
