// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/asked_bus_views.h"
#include "kinds/esc/line/esc_line_scan.h"
#include "vocabulary/refusal.h"
#include "widgets/help/key_help.h"

#include <QPointer>

#include <array>

namespace codewheel {

class EscLineActions;
class EscLineKeeper;
class EscLinePanel;
class EscLineSearch;
class EscLineSession;
class EscLineSettingsForm;
class EscLineTerminal;
class EscLineTrainingPanel;
class EscLineAtWork;

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
class EscLineViews final : public AskedBusViews
{
    Q_OBJECT

public:
    EscLineViews(EscLineAtWork &line, const WindowParts &windowParts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override;
    void setChosen(std::optional<Place> place) override;
    void setRecordingChosen(bool isChosen) override;
    void open() override;
    bool open(Place place) override; // its terminal, since it has no words
    void connectTraining() override { connectSimulated(); }
    void connectFound(const KindData &plan, const std::vector<KindData> &devices) override;
    void showFrame() override;
    void useSettings(const ProgramSettings &settings) override;
    FaultBanner::Offer offer(const Fault &fault, FaultAction action) const override;
    void act(const Fault &fault, FaultAction action) override;

    void showSettings() override;

private:
    EscLineSession *session() const;
    void setBus(AskedBus *bus) override;
    TrainingArea *training() const override;
    ShownStatus status() const override;
    KindData wanted(const KindData &plan) const override;
    void keepLink(const KindData &plan) override;
    void test(const KindData &plan) override;
    void showOpened() override;
    void jobEnded(const EncoderSession &encoder, const Outcome &outcome) override;
    void showChosen() override;
    void showEncoders() override;
    void agree(); // to another adapter
    std::any takeRows() override;
    void showRows(const std::any &rows) override;
    void showTerminal();
    void determineFractionBits();
    // From now on its warnings are read with their two bytes swapped, or as they come.
    void swapWarningBytes(bool on);
    void showFound();
    void showState();
    void takeOver(const std::vector<FoundEncoder> &found, const QString &deviceKey);
    void askForOtherAdapter(const Refusal &which);
    void takeFractionBits(const Result<int> &bits);
    void tellBaudRate(Place encoder, int rate);
    void explainTerminal();

    EscLineAtWork &m_line;
    EscLineActions &m_actions;
    EscLineKeeper *m_keeper;
    bool m_takesOther = false; // keep another adapter once it is open
    EscLineTerminal *m_terminal;
    EscLinePanel *m_panel;
    EscLineSettingsForm *m_form;
    EscLineSearch *m_search;
    EscLineTrainingPanel *m_training;
    bool m_isFound = false; // its port, by the finder
    std::vector<FoundEncoder> m_foundThere;
};

} // namespace codewheel
