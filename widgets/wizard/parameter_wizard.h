// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/page.h"
#include "widgets/look/quick_press.h"
#include "widgets/wizard/handshake_page.h"
#include "widgets/wizard/setup.h"

#include <functional>
#include <memory>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace codewheel {

class DevicePage;
class HandshakePage;
class StepList;
class WizardPage;

// Parameterizes one encoder, page by page: encoder, what is known, direction, values, review, handshake,
// report. A page of the main window, no dialog. Sends nothing before the review.
class ParameterWizard : public codewheel::Page
{
    Q_OBJECT

public:
    enum Page { device, known, direction, values, review, handshake, report };
    static constexpr int pageCount = report + 1;

    // Both must outlive the wizard.
    ParameterWizard(Buses &buses, WantedValues &wanted, QWidget *parent = nullptr);
    ~ParameterWizard() override;

    // The one chosen in the bus structure. It is followed until the first step; after that the wizard stays
    // with its encoder until it is closed.
    void setEncoder(codewheel::EncoderSession *encoder);
    EncoderSession *encoder() const;

    // What is under way, for the wizard in another language; this one goes.
    struct UnderWay
    {
        QPointer<EncoderSession> encoder;
        WriteWish wish;
        std::map<Parameter, Setup::Given> given;
        bool byHand = true;
        bool hasChosenPosition = false;
        HandshakeRecord record;
        HandshakePage::UnderWay handshake;
        Page page = device;
    };
    UnderWay takeUnderWay();
    void goOn(const UnderWay &before);

    void focusPage();    // gives the shown page the focus
    bool isBusy() const; // a handshake is running

    using StationOf = std::function<QString(Place)>; // in the project; empty: none
    void setStations(StationOf stationOf) { m_stationOf = std::move(stationOf); }

    Page page() const;
    QString title() const override;
    QString about() const override;
    QString effect() const override;
    QString lostByClosing() const override; // the settings made here; looking at the monitors keeps them
    void leave() override;

Q_SIGNALS:
    void encoderChosen(codewheel::Place place);      // in its list
    void goesOn(const codewheel::FollowingJob &job); // its handshake has another job

private:
    void makePages();
    void beginAnew();
    void choose(EncoderSession *encoder);
    void follow(EncoderSession *encoder);
    void showPage(int page);
    void next();
    void back();
    void cancel();
    void showButtons();
    void takeProgress(const Progress &progress);
    void takeOutcome(const Outcome &outcome);
    void takeRow(const Exchange &row);
    WizardPage *current() const;

    std::unique_ptr<Setup> m_setup;
    QPointer<EncoderSession> m_chosen; // in the bus structure
    StationOf m_stationOf = [](Place) { return QString(); };
    std::vector<WizardPage *> m_all;
    DevicePage *m_devicePage = nullptr;
    HandshakePage *m_handshakePage = nullptr;
    StepList *m_stepList;
    QLabel *m_stepName; // if there is no room for the list
    QStackedWidget *m_pages;
    QuickPress m_press;
    QPushButton *m_cancel;
    QPushButton *m_back;
    QPushButton *m_next;
};

} // namespace codewheel
