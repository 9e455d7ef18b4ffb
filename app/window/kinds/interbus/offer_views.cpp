// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/offer_views.h"

#include "app/window/connect/trouble_of.h"
#include "app/window/kinds/interbus/offer_files.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/kinds/interbus/ring_offer.h"
#include "app/window/look/status_line.h"
#include "app/window/window_settings.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "links/own_addresses.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/interbus/offer/offer_form.h"
#include "widgets/kinds/interbus/offer/offer_page.h"
#include "widgets/kinds/interbus/offer/offer_wish.h"
#include "widgets/kinds/interbus/offer/offered_view.h"
#include "widgets/kinds/interbus/offer/seat_panel.h"
#include "widgets/kinds/interbus/offer/seats_view.h"
#include "widgets/look/role_label.h"
#include "widgets/project/project_document.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include <algorithm>

namespace codewheel {
namespace {

const QString offerAddressKey = QStringLiteral("offer/address");
const QString offerPortKey = QStringLiteral("offer/port");
const QString offerHasSeatsKey = QStringLiteral("offer/hasSeats");
const QString offerSeatsKey = QStringLiteral("offer/seats");
const QString offerReadOnlyKey = QStringLiteral("offer/readOnly");

int number(const QSettings &settings, const QString &key, int usual, int least, int most)
{
    return std::clamp(settings.value(key, usual).toInt(), least, most);
}

// How a ring was offered last.
OfferWish lastOffer(const QSettings &settings)
{
    const OfferWish usual;
    return {.address = settings.value(offerAddressKey, usual.address).toString(),
            .port = number(settings, offerPortKey, usual.port, 0, OfferWish::lastPort),
            .hasSeats = settings.value(offerHasSeatsKey, usual.hasSeats).toBool(),
            .seats = number(settings, offerSeatsKey, usual.seats, 1, OfferWish::mostSeats),
            .readOnly = settings.value(offerReadOnlyKey, usual.readOnly).toBool()};
}

void keepOffer(QSettings &settings, const OfferWish &wish)
{
    settings.setValue(offerAddressKey, wish.address);
    settings.setValue(offerPortKey, wish.port);
    settings.setValue(offerHasSeatsKey, wish.hasSeats);
    settings.setValue(offerSeatsKey, wish.seats);
    settings.setValue(offerReadOnlyKey, wish.readOnly);
}

} // namespace

OfferViews::OfferViews(RingAtWork &ring, OfferPage &page, WindowSettings &settings, StatusLine &status,
                       QObject *parent)
    : QObject(parent)
    , m_offer(ring.offer())
    , m_ring(ring)
    , m_page(page)
    , m_settings(settings)
    , m_line(status)
    , m_status(status.addState())
{
    m_status->setObjectName(QStringLiteral("offerState"));
    m_status->setToolTip(tr("A simulated ring is offered to others (Bus > Training > Offer to others)"));
    connect(&page, &OfferPage::offerWanted, this, &OfferViews::begin);
    connect(&page, &OfferPage::endWanted, this, &OfferViews::end);
    connect(&page, &OfferPage::filesWanted, this, &OfferViews::saveFiles);
    connect(&seats(), &SeatsView::restartWanted, this, &OfferViews::askToRestart);
    connect(&seats(), &SeatsView::choiceChanged, this, &OfferViews::showSeats);
    connect(&seats().panel(), &SeatPanel::acted, this,
            [this](int unit, Place place, const TrainingAct &what) {
                if (m_offer.isOn())
                    m_offer.tellOfSeat(unit, place.node, what);
            });
    connect(&m_offer, &RingOffer::changed, this, &OfferViews::showPlace);
    connect(&ring.project(), &ProjectDocument::changed, this, &OfferViews::showName);
    page.form().show(lastOffer(settings.ofKinds()));
    showName();
    showPlace();
}

OfferViews::~OfferViews()
{
    delete m_status;
    delete m_question;
}

QString OfferViews::whyNot() const
{
    const auto why = m_offer.whyNot();
    return why ? refusalText(*why) : QString();
}

bool OfferViews::isOn() const
{
    return m_offer.isOn();
}

void OfferViews::end()
{
    if (m_offer.connectedClients() == 0)
        m_offer.end();
    else
        askToEnd();
}

void OfferViews::askToEnd()
{
    QPushButton *stop =
        ask({tr("Stop offering"), tr("Stop offering and disconnect all clients?"), m_offer.endsForClients(),
             tr("&Stop offering"), tr("Disconnects all clients (Alt+S)")});
    connect(stop, &QPushButton::clicked, &m_offer, &RingOffer::end);
}

// A seat that nobody has used has nothing to lose.
void OfferViews::askToRestart(int unit)
{
    const auto restart = [this, unit] {
        m_offer.restart(unit);
        showSeats(); // without the ring before
    };
    const QString lost = m_offer.restartsForClients(unit);
    if (lost.isEmpty()) {
        restart();
        return;
    }
    const QPushButton *yes =
        ask({tr("Start seat afresh"), tr("Give seat %1 a new ring, with factory settings?").arg(unit), lost,
             tr("&Start afresh"), tr("The ring of this seat begins anew (Alt+S)")});
    connect(yes, &QPushButton::clicked, this, restart);
}

// Not by exec(): the offer may end, or the window be rebuilt, while it is open.
QPushButton *OfferViews::ask(const Question &question)
{
    withdrawQuestion();
    m_question = new QMessageBox(QMessageBox::Question, question.title, question.text, QMessageBox::NoButton,
                                 m_page.window());
    m_question->setObjectName(QStringLiteral("offerQuestion"));
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    setHelpTopic(*m_question, "serving.md#in-the-window");
    m_question->setInformativeText(question.lost);
    QPushButton *yes = m_question->addButton(question.yes, QMessageBox::AcceptRole);
    yes->setToolTip(question.toolTip);
    m_question->setDefaultButton(m_question->addButton(QMessageBox::Cancel));
    m_question->open();
    return yes;
}

void OfferViews::withdrawQuestion()
{
    if (m_question)
        m_question->reject();
    m_question = nullptr;
}

void OfferViews::listAddresses()
{
    m_page.form().setAddresses(ownAddresses());
    m_page.setWhyNot(whyNot());
}

void OfferViews::showName()
{
    const PlannedBus *bus = findBus(m_ring.project().project(), m_ring.id());
    m_page.setAbout(bus != nullptr ? bus->name : m_ring.nameOfNew());
}

void OfferViews::begin(const OfferWish &wish)
{
    if (const auto begun = m_offer.begin(wish); !begun)
        m_page.setProblem(troubleOf(begun.error()));
    else
        keepOffer(m_settings.ofKinds(), wish);
}

void OfferViews::showPlace()
{
    if (!m_offer.isOn())
        withdrawQuestion();
    m_page.setPlace(m_offer.isOn() ? std::optional(m_offer.place()) : std::nullopt);
    if (m_offer.isOn())
        m_page.offered().setDevices(m_offer.devices());
    m_status->setVisible(m_offer.isOn());
    showSeats();
    showFrame();
    Q_EMIT changed();
}

void OfferViews::showFrame()
{
    m_page.setWhyNot(whyNot());
    if (!m_offer.isOn())
        return;
    m_offer.takeFrame();
    showStatus();
    if (m_page.isVisible()) {
        m_page.offered().showClients(m_offer.clients(), m_offer.counts());
        showSeats();
    }
}

SeatsView &OfferViews::seats() const
{
    return m_page.offered().seats();
}

void OfferViews::showSeats()
{
    const auto chosen = m_offer.isOn() ? seats().chosen() : std::nullopt;
    if (const auto controls = chosen ? m_offer.controls(*chosen) : nullptr)
        seats().panel().showSeat(*chosen, m_ring.id(), controls);
    else
        seats().panel().leave();
    if (m_offer.isOn())
        seats().show(m_offer.seats(seats().device()));
}

void OfferViews::saveFiles()
{
    const QFileInfo project(m_ring.project().file());
    const auto saved =
        OfferFiles(m_offer, ownAddresses(), project.exists() ? project.path() : QString(), m_page).save();
    if (!saved)
        return;
    m_page.tell(saved->role, saved->sentence);
}

void OfferViews::showStatus()
{
    const OfferedPlace place = m_offer.place();
    const ClientCounts counts = m_offer.counts();
    const QString text =
        sentence(tr("Offered at %1, %2"),
                 {place.address, tr("%n clients", nullptr, static_cast<int>(counts.came - counts.left))});
    const Role role = place.reachesOthers ? Role::attention : Role::running;
    if (m_status->word() == text && m_status->role() == role)
        return;
    m_status->setState(role, text);
    m_line.fit();
}

} // namespace codewheel
