// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/setup/lss_search.h"
#include "kinds/canopen/setup/node_check.h"
#include "kinds/canopen/setup/node_setup.h"
#include "kinds/canopen/setup/node_task_run.h"
#include "vocabulary/message.h"
#include "vocabulary/role.h"
#include "widgets/kinds/canopen/setup/node_setup_texts.h"

#include <QPointer>
#include <QWidget>

#include <memory>

class QComboBox;
class QLabel;
class QPushButton;

namespace codewheel {

class CanopenSession;
class EepromGate;
class InlineMessage;
class NodeNumberField;
class SetupSteps;

// Gives a device on a CAN bus its number and rate: reads who it is, says what will happen, asks, writes step
// by step, and looks for it afterwards and once more when its supply was off. Used by NodeSetupPage, and when
// an encoder is replaced.
class NodeSetupView : public QWidget
{
    Q_OBJECT

public:
    explicit NodeSetupView(QWidget *parent = nullptr);
    ~NodeSetupView() override;

    void setBus(codewheel::CanopenSession *bus); // null: none
    // The device it is about; nothing is sent. Not while it is busy.
    void setNode(std::optional<int> node); // empty: one without a number, to be found
    // Whoever is read gets this number, although the encoder it replaces is still in the bus structure.
    void setReplacing(int number);
    void reset();

    bool isBusy() const { return m_run.isRunning(); }
    // It has got what it was to get, and was found with it.
    bool isFound() const { return m_isFound; }
    // It was written to, and has not been checked without supply.
    bool isToBeProven() const { return m_stage == Stage::toBeProven; }
    bool isProven() const { return m_stage == Stage::proven; }
    std::optional<int> node() const { return m_node; } // of the device; empty: it has none, or none is meant
    const std::optional<canopen::NodeIdentity> &identity() const { return m_identity; } // of it, as read
    QString about() const;                                                              // it, in short

    void search(); // for a device without a number

    // What would be cut off if the bus were left now, and what that leads to; empty: nothing.
    std::optional<node_setup_text::AtStake> atStake() const;
    // What was not sent yet is not, apart from what leaves the device as it should be.
    void breakOff() { m_run.cancel(); }
    // Nothing of it is under way or in doubt: what was written was found, or nothing was written.
    bool isSettled() const;

Q_SIGNALS:
    void changed(); // any of the above
    void aboutToWrite();
    void messaged(const codewheel::Message &message);
    // It is there with its new number. 0: it had none before.
    void numbered(int before, int after);

private:
    enum class Stage : std::uint8_t {
        unread,    // who it is is not known
        reading,   //
        searching, //
        read,      //
        writing,   //
        checking,  //
        toBeProven,
        proving,
        proven,
    };

    QLayout *makeFields();
    QLayout *makeButtons();
    void read();
    void takeRead();
    void takeSearched();
    void ask();
    void send();
    void takeWritten();
    void check();
    void takeChecked();
    void takeEnd();
    void tell(Role role, const QString &sentence);
    void tellProblem(const QString &sentence);
    void setStage(Stage stage);
    void showDevice();
    void showWays();
    void showConsequences();
    void showSteps();
    void showWhatIsPossible();
    void focusNext();
    canopen::NodeSetupWish wish() const;
    QString whyNotSent() const;  // anything; empty: it can be
    QString whyNotAsked() const; // what was entered; empty: it can be
    std::optional<canopen::SdoObject> nodeObject() const;

    QPointer<CanopenSession> m_bus;
    NodeTaskRun m_run;
    Stage m_stage = Stage::unread;
    std::optional<int> m_node; // of the device; empty: it has none
    std::optional<int> m_replacing;
    std::optional<canopen::NodeIdentity> m_identity; // read
    canopen::NodeSetupWish m_wanted;                 // as asked about
    bool m_isFound = false;
    bool m_isRateStored = false;
    canopen::BootUps m_bootUps{}; // heard at its number when its supply was to be switched
    std::unique_ptr<canopen::IdentityReading> m_reading;
    std::unique_ptr<canopen::LssSearch> m_search;
    std::unique_ptr<canopen::NodeSetup> m_setup;
    std::unique_ptr<canopen::NodeCheck> m_check;
    QLabel *m_device;
    QPushButton *m_read;
    QPushButton *m_find;
    QWidget *m_fields;
    QComboBox *m_way;
    NodeNumberField *m_number;
    QComboBox *m_rate;
    QLabel *m_consequences;
    EepromGate *m_gate;
    QPushButton *m_write;
    QPushButton *m_cancel;
    QPushButton *m_checkNow;
    InlineMessage *m_message;
    SetupSteps *m_steps;
};

} // namespace codewheel
