// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/label_key.h"
#include "encoder/place.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace codewheel {

class BusSession;
class InlineMessage;
struct Participant;

// Null where there is no such device.
const Participant *participantAt(const BusSession &bus, std::optional<Place> number);
// A bus terminal has no make that matters and nothing to describe.
bool isBusTerminal(const Participant *participant);

// "Which encoder is 1.0?": the key on its label, or a choice of the catalog's devices of its device code.
// Name gives the place that driver; nothing is sent. A key is looked up even where it is no place's. Stands
// in the DevicePanel.
class NamingBar : public QWidget
{
    Q_OBJECT

public:
    explicit NamingBar(BusSession &bus, QWidget *parent = nullptr);

    // The device to be named; nothing: keys are only looked up.
    void setPlace(std::optional<Place> number);
    void focusKey();
    // What the typed key stands for; null where it is empty or not understood.
    const LabelMatch *looked() const { return m_matches.empty() ? nullptr : &m_matches.front(); }

Q_SIGNALS:
    void lookedUp(); // looked() is another one

private:
    void fillChoices();
    void read(const QString &typed);
    void tellProblem();
    void chooseMatch();
    void name();
    void ask();

    BusSession &m_bus;
    std::optional<Place> m_number;
    std::vector<LabelMatch> m_matches;
    std::optional<Refusal> m_problem; // of the typed key
    QLabel *m_question;
    QLineEdit *m_key;
    QComboBox *m_choice;
    QPushButton *m_name;
    QLabel *m_reading;
    InlineMessage *m_message;
};

} // namespace codewheel
