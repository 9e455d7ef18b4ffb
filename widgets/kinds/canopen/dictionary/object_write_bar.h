// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/objects_heard.h"
#include "widgets/kinds/canopen/dictionary/object_model.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace codewheel {

class InlineMessage;
class ObjectTransfers;

// Gives the chosen object another value: it is read, the write is asked for with what is there and what is to
// be, it is sent once, and read back.
class ObjectWriteBar : public QWidget
{
    Q_OBJECT

public:
    explicit ObjectWriteBar(ObjectTransfers &transfers, QWidget *parent = nullptr);

    // Empty: none is chosen. Another one withdraws the question.
    void setObject(const std::optional<canopen::FileObject> &object, std::optional<int> node);
    void setWhyNot(const QString &whyNot); // empty: frames can be sent to the node
    // Why the file may be that of another device, which the question says; empty: nothing speaks for that.
    void setDoubt(const QString &doubt) { m_doubt = doubt; }
    // The file names its device, and the node has not told yet who it is: it is asked that as well.
    void setAsksWho(bool asks) { m_asksWho = asks; }
    // What was to be agreed to is not true any more.
    void takeWrittenByOther(const canopen::HeardObject &heard);

Q_SIGNALS:
    void begun(); // a write: what was said before is over

private:
    enum class Step : std::uint8_t { nothing, readsBefore, asks, writes, readsBack };

    QString whyNotWritten() const;
    void showWhatIsPossible();
    void reset();
    void begin();
    void ask();
    QString question(const std::vector<std::uint8_t> &octets) const;
    QString warnings(const std::vector<std::uint8_t> &octets) const;
    QString textOf(const std::vector<std::uint8_t> &octets) const;
    std::optional<std::vector<std::uint8_t>> typedOctets() const;
    bool isRead() const; // it can be
    void writeNow();
    void takeEnd(const canopen::SdoRequest &request, const canopen::SdoOutcome &outcome);
    void takeRefused();
    void takeBefore(canopen::SdoObject object, const canopen::SdoOutcome &outcome);
    void takeWritten(const canopen::SdoOutcome &outcome);
    void tellReadBack(const canopen::SdoOutcome &outcome);
    void tellAborted(const canopen::SdoOutcome &outcome);

    ObjectTransfers &m_transfers;
    std::optional<canopen::FileObject> m_object;
    std::optional<int> m_node;
    QString m_whyNot;
    QString m_doubt;
    bool m_asksWho = false;
    Step m_step = Step::nothing;
    std::optional<canopen::SdoObject> m_lastBefore; // that is read before the question
    canopen::SdoOutcome m_before;
    bool m_isAcknowledged = false; // the write
    std::vector<std::uint8_t> m_octets;
    QLabel *m_label;
    QLineEdit *m_field;
    QPushButton *m_write;
    InlineMessage *m_question;
    InlineMessage *m_message;
};

} // namespace codewheel
