// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/encoder_bus.h"
#include "catalog/label_key.h"

#include <QPointer>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace codewheel {

class Catalog;
class InlineMessage;

// A bus terminal has no make that matters, and nothing to describe.
bool isCoupler(const EncoderBus &bus, Place place);

// "Which encoder is 1.0?": asks for the key on its label, or a choice among the catalog's devices with its
// device code. Name gives the place that driver; nothing is sent. A key is looked up even if it fits no
// place. Part of the DevicePanel.
class NamingBar : public QWidget
{
    Q_OBJECT

public:
    // The catalog outlives it.
    explicit NamingBar(const Catalog &catalog, QWidget *parent = nullptr);

    // The device to be named; without bus and place, keys are only looked up.
    void setPlace(EncoderBus *bus, std::optional<Place> number);
    void focusKey();
    // The match of the typed key; null if it is empty or not understood.
    const LabelMatch *looked() const { return m_matches.empty() ? nullptr : &m_matches.front(); }

Q_SIGNALS:
    void lookedUp(); // looked() has changed

private:
    void fillChoices();
    void read(const QString &typed);
    void tellProblem();
    void chooseMatch();
    void name();
    void ask();

    const Catalog &m_catalog;
    QPointer<EncoderBus> m_bus; // of the device
    std::optional<Place> m_number;
    std::optional<Participant> m_device; // to be named
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
