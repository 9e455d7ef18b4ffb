// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/monitor_area.h"

#include "bus/word_channel.h"
#include "catalog/device_description.h"
#include "history/track.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/dragged_place.h"
#include "widgets/monitor/word_card.h"

#include <QDragEnterEvent>
#include <QJsonArray>
#include <QScrollArea>
#include <QStackedWidget>

#include <algorithm>

namespace codewheel {

namespace {

const QLatin1String pinnedKey("pinned");
const QLatin1String displayKey("display");
const QLatin1String wordsKey("monitors"); // of older layouts: one entry per word
const QLatin1String placeKey("place");

} // namespace

MonitorArea::MonitorArea(Buses &buses, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_pages(new QStackedWidget(this))
    , m_empty(new EmptyState(Icon::monitor, {}, {}, this))
    , m_scroll(new QScrollArea(this))
{
    setAcceptDrops(true);
    layOut<QVBoxLayout>(this, 0)->addWidget(m_pages);
    m_pages->addWidget(m_empty);
    auto *column = new QWidget;
    m_column = layOut<QVBoxLayout>(column, grid::unit, grid::unit);
    m_note = wrappedLabel(column, "whyNoMonitor");
    m_column->addWidget(m_note);
    m_column->addStretch(1);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidget(column);
    m_pages->addWidget(m_scroll);

    connect(&buses, &Buses::updated, this, &MonitorArea::showFrame);
    connect(&buses, &Buses::changed, this, [this] {
        followDevices();
        bringBack();
        showFollowing();
        for (WordCard *card : m_cards)
            card->busStateChanged();
    });
    showWhatThereIs();
}

void MonitorArea::dragEnterEvent(QDragEnterEvent *event)
{
    if (const auto place = placeDragged(*event->mimeData()); place && canShow(*place))
        event->acceptProposedAction();
}

void MonitorArea::dropEvent(QDropEvent *event)
{
    if (const auto place = placeDragged(*event->mimeData()); place && canShow(*place)) {
        event->acceptProposedAction();
        pin(*place);
    }
}

void MonitorArea::setStations(std::function<QString(Place)> stationOf)
{
    m_stationOf = std::move(stationOf);
    showStations();
}

void MonitorArea::showStations()
{
    for (WordCard *card : m_cards)
        card->setStation(m_stationOf ? m_stationOf(card->place()) : QString());
}

bool MonitorArea::canShow(Place place) const
{
    const WordChannel *channel = m_buses.channel(place);
    return channel != nullptr && WordCard::canShow(*channel);
}

QString MonitorArea::whyNot(Place place) const
{
    if (!m_buses.isConnected(place))
        return tr("%1 is not connected: its words are shown once it is.").arg(place.shown());
    if (m_buses.channel(place) == nullptr && m_buses.encoder(place) != nullptr)
        return tr("%1 has no words: its position and the traffic of its bus have panels of their own.")
            .arg(place.shown());
    return tr("%1 has no words to show: it takes no part in the process data.").arg(place.shown());
}

void MonitorArea::follow(std::optional<Place> chosen)
{
    if (std::exchange(m_chosen, chosen) != chosen)
        m_isClosed = false;
    showFollowing();
}

// The chosen device has one if it has words and is not already pinned.
void MonitorArea::showFollowing()
{
    const bool isWanted = m_chosen && !m_isClosed && canShow(*m_chosen) && find(true, *m_chosen) == nullptr;
    const auto following = std::ranges::find(m_cards, false, &WordCard::isPinned);
    const bool isThere = following != m_cards.end();
    if (isThere && !(isWanted && (*following)->place() == *m_chosen))
        remove(*following);
    else if (isThere)
        return;
    if (isWanted)
        add(*m_chosen, false);
    showWhatThereIs();
}

void MonitorArea::open(Place place)
{
    if (place == m_chosen)
        m_isClosed = false;
    else
        pin(place);
    showFollowing();
    if (WordCard *opened = card(place)) {
        m_column->activate();
        m_scroll->ensureWidgetVisible(opened, 0, 0);
        opened->setFocus();
    }
}

void MonitorArea::pin(Place place)
{
    if (!canShow(place) || find(true, place) != nullptr)
        return;
    if (WordCard *following = find(false, place))
        setPinned(following, true);
    else
        add(place, true);
    notePinned(place, true);
}

void MonitorArea::notePinned(Place place, bool pinned)
{
    std::erase(m_pinned, place);
    if (pinned)
        m_pinned.push_back(place);
}

void MonitorArea::setPinned(WordCard *card, bool pinned)
{
    card->setPinned(pinned);
    notePinned(card->place(), pinned);
    if (pinned)
        return;
    if (card->place() == m_chosen) {
        const auto at = std::ranges::find(m_cards, card);
        std::rotate(m_cards.begin(), at, at + 1);
        m_column->removeWidget(card);
        m_column->insertWidget(1, card);
    } else {
        remove(card);
        showWhatThereIs();
    }
}

void MonitorArea::closed(WordCard *card)
{
    m_isClosed = m_isClosed || card->place() == m_chosen;
    notePinned(card->place(), false);
    remove(card);
    showWhatThereIs();
}

void MonitorArea::close(Place place)
{
    if (WordCard *open = card(place))
        closed(open);
}

void MonitorArea::closeAll()
{
    while (!m_cards.empty())
        closed(m_cards.back());
}

WordCard *MonitorArea::card(Place place) const
{
    const auto found = std::ranges::find(m_cards, place, &WordCard::place);
    return found == m_cards.end() ? nullptr : *found;
}

WordCard *MonitorArea::find(bool pinned, Place place) const
{
    WordCard *found = card(place);
    return found != nullptr && found->isPinned() == pinned ? found : nullptr;
}

// The one that follows goes first, below the note; the others in the order in which they were pinned.
WordCard *MonitorArea::add(Place place, bool pinned)
{
    WordCard *card = make(place);
    card->setPinned(pinned);
    m_cards.insert(pinned ? m_cards.end() : m_cards.begin(), card);
    m_column->insertWidget(pinned ? m_column->count() - 1 : 1, card);
    showWhatThereIs();
    return card;
}

WordCard *MonitorArea::make(Place place)
{
    WordChannel *channel = m_buses.channel(place);
    EncoderSession *encoder = m_buses.encoder(place);
    auto *card = new WordCard(*channel, encoder, encoder ? &encoder->device() : nullptr, m_scroll->widget());
    card->setDisplay(m_display);
    card->setStation(m_stationOf ? m_stationOf(place) : QString());
    card->showFrame(m_buses.open(place.bus)->now());
    connect(card, &WordCard::closeRequested, this, [this, card] { closed(card); });
    connect(card, &WordCard::pinToggled, this, [this, card](bool pinned) { setPinned(card, pinned); });
    connect(card, &WordCard::displayChosen, this, &MonitorArea::setDisplay);
    connect(card, &WordCard::trendWanted, this, &MonitorArea::trendWanted);
    connect(channel, &QObject::destroyed, card, [this, card] { remove(card); });
    return card;
}

void MonitorArea::remove(WordCard *card)
{
    std::erase(m_cards, card);
    card->hide();
    card->deleteLater();
}

// Keeps its position.
void MonitorArea::makeAnew(WordCard *card)
{
    WordCard *fresh = make(card->place());
    fresh->setPinned(card->isPinned());
    std::ranges::replace(m_cards, card, fresh);
    m_column->insertWidget(m_column->indexOf(card), fresh);
    remove(card);
}

// Removes the monitors of devices that are gone, and replaces those whose device, make or place name has
// changed.
void MonitorArea::followDevices()
{
    const auto before = m_cards;
    for (WordCard *card : before)
        if (!canShow(card->place()))
            remove(card);
        else if (card->channel() != m_buses.channel(card->place()) ||
                 card->encoder() != m_buses.encoder(card->place()) || card->isNamedAnew())
            makeAnew(card);
}

void MonitorArea::bringBack()
{
    for (const Place place : m_pinned)
        if (canShow(place) && card(place) == nullptr)
            add(place, true);
}

void MonitorArea::setDisplay(const MonitorDisplay &display)
{
    m_display = display;
    for (WordCard *card : m_cards)
        card->setDisplay(display);
}

void MonitorArea::showFrame(BusId bus)
{
    const EncoderBus *shown = m_buses.open(bus);
    for (WordCard *card : m_cards)
        if (shown != nullptr && card->place().bus == bus)
            card->showFrame(shown->now());
}

// A note says so if a device has no words, above the pinned monitors or in their place.
void MonitorArea::showWhatThereIs()
{
    const bool isMissing = m_chosen && !m_isClosed && !canShow(*m_chosen);
    const QString why = isMissing ? whyNot(*m_chosen) : QString();
    m_note->setText(why);
    m_note->setVisible(isMissing);
    m_empty->setTexts(tr("No monitor is open"),
                      isMissing
                          ? why
                          : tr("A monitor shows the words of a device, and lets you set the bits of its "
                               "OUT word. Choose a device in the bus structure."));
    m_pages->setCurrentIndex(m_cards.empty() ? 0 : 1);
}

QJsonObject MonitorArea::state() const
{
    QJsonArray pinned;
    for (const Place place : m_pinned)
        pinned.append(place.key());
    return {{pinnedKey, pinned}, {displayKey, m_display.toJson()}};
}

void MonitorArea::restoreState(const QJsonObject &state)
{
    closeAll();
    m_pinned.clear();
    m_isClosed = false;
    setDisplay(MonitorDisplay::fromJson(state.value(displayKey).toObject()));
    QJsonArray places = state.value(pinnedKey).toArray();
    for (const QJsonValue word : state.value(wordsKey).toArray())
        places.append(word[placeKey]);
    for (const QJsonValue key : places)
        if (const auto place = Place::parse(key.toString()))
            notePinned(*place, true);
    bringBack();
    showFollowing();
}

} // namespace codewheel
