// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QMessageBox;
class QPushButton;

namespace codewheel {

class OfferPage;
struct OfferWish;
class RingAtWork;
class RingOffer;
class RoleLabel;
class SeatsView;
class StatusLine;
class WindowSettings;

// What the window shows of a ring that is offered to others: its page, and the status line, also when the
// page is closed. Used by RingViews.
class OfferViews : public QObject
{
    Q_OBJECT

public:
    OfferViews(RingAtWork &ring, OfferPage &page, WindowSettings &settings, StatusLine &status,
               QObject *parent = nullptr);
    ~OfferViews() override;

    // Why it cannot be offered now, in a sentence; empty: it can.
    QString whyNot() const;
    bool isOn() const;
    void end();           // asks first if clients are connected
    void listAddresses(); // of this computer, as they are now
    void showFrame();

Q_SIGNALS:
    void changed();

private:
    void begin(const OfferWish &wish);
    struct Question
    {
        QString title;
        QString text;
        QString lost; // with "yes"
        QString yes;
        QString toolTip;
    };
    void askToEnd();
    void askToRestart(int unit);
    QPushButton *ask(const Question &question); // returns "yes"
    void withdrawQuestion();
    void showPlace();
    void showStatus();
    SeatsView &seats() const;
    void showSeats();
    void saveFiles();
    void showName();

    RingOffer &m_offer;
    RingAtWork &m_ring;
    OfferPage &m_page;
    WindowSettings &m_settings;
    StatusLine &m_line;
    QPointer<RoleLabel> m_status;
    QPointer<QMessageBox> m_question; // whether to end it, or to start a seat afresh
};

} // namespace codewheel
