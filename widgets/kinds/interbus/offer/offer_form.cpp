// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/offer_form.h"

#include "vocabulary/sentence.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/look/wrapped_radio_button.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>

namespace codewheel {
namespace {

const QString allAddresses = QStringLiteral("0.0.0.0");

QString addressText(const QString &address)
{
    if (address == OfferWish().address)
        return sentence(OfferForm::tr("This computer only: %1"), {address});
    if (address == allAddresses)
        return sentence(OfferForm::tr("All addresses of this computer: %1"), {address});
    return address;
}

} // namespace

OfferForm::OfferForm(QWidget *parent)
    : QWidget(parent)
    , m_address(describe(new QComboBox(this), "offerAddress", tr("Where"),
                         tr("Whether programs on other computers reach it, and at which address")))
    , m_warning(wrappedLabel(this, "offerWarning"))
    , m_port(describe(new IntegerField(this), "offerPort", tr("Port"),
                      tr("1502, or another free one from 1024 on; 502 is for administrators")))
    , m_oneRing(describe(new WrappedRadioButton(tr("One ring for &all"), this), "oneRing",
                         tr("All clients work on the ring of this window, whatever unit they ask")))
    , m_eachSeat(describe(new WrappedRadioButton(tr("A ring for each &seat"), this), "eachSeat",
                          tr("Each seat has a ring of its own, with the devices of this one: unit 1 is seat "
                             "1. The ring of this window is nobody's seat")))
    , m_seats(describe(new IntegerField(this), "seats", tr("Seats"), tr("How many seats there are: 1 to 64")))
    , m_readOnly(describe(new QCheckBox(tr("Clients may onl&y read"), this), "readOnly",
                          tr("What they want to write is refused with exception 1")))
{
    m_port->setRange(0, OfferWish::lastPort);
    m_port->setSpecialValueText(tr("any free one"));
    leaveSeparatorsOut(*m_port);
    m_seats->setRange(1, OfferWish::mostSeats);
    m_warning->setFont(textFont(TextSize::small));
    auto *form = makeForm(this, grid::margin);
    makeWhere(*form);
    makeRings(*form);
    setFocusProxy(m_address);
    setAddresses({});
    show({});
}

void OfferForm::makeWhere(QFormLayout &form)
{
    form.addRow(tr("&Where"), m_address);
    form.addRow(QString(), m_warning);
    form.addRow(tr("&Port"), m_port);
    connect(m_address, &QComboBox::currentIndexChanged, this, &OfferForm::showChoices);
    connect(m_address, &QComboBox::activated, this, &OfferForm::edited);
    connect(m_port, &QSpinBox::valueChanged, this, &OfferForm::edited);
}

void OfferForm::makeRings(QFormLayout &form)
{
    form.addRow(tr("Rings"), m_oneRing);
    form.addRow(QString(), m_eachSeat);
    form.addRow(tr("Sea&ts"), m_seats);
    form.addRow(QString(), m_readOnly);
    connect(m_eachSeat, &QRadioButton::toggled, this, &OfferForm::showChoices);
    connect(m_eachSeat, &QRadioButton::toggled, this, &OfferForm::edited);
    connect(m_seats, &QSpinBox::valueChanged, this, &OfferForm::edited);
    connect(m_readOnly, &QCheckBox::toggled, this, &OfferForm::edited);
}

void OfferForm::addAddress(const QString &address)
{
    if (m_address->findData(address) < 0)
        m_address->addItem(addressText(address), address);
}

void OfferForm::setAddresses(const QStringList &addresses)
{
    const QString before = m_address->currentData().toString();
    {
        const QSignalBlocker quiet(m_address);
        m_address->clear();
        addAddress(OfferWish().address);
        for (const QString &address : addresses)
            addAddress(address);
        addAddress(allAddresses);
    }
    choose(before.isEmpty() ? OfferWish().address : before);
}

// One that this computer does not have at the moment stays: offering it says so.
void OfferForm::choose(const QString &address)
{
    addAddress(address);
    m_address->setCurrentIndex(m_address->findData(address));
    showChoices();
}

void OfferForm::show(const OfferWish &wish)
{
    choose(wish.address);
    m_port->setValue(wish.port);
    m_oneRing->setChecked(!wish.hasSeats);
    m_eachSeat->setChecked(wish.hasSeats);
    m_seats->setValue(wish.seats);
    m_readOnly->setChecked(wish.readOnly);
    showChoices();
}

OfferWish OfferForm::wish() const
{
    return {.address = m_address->currentData().toString(),
            .port = m_port->value(),
            .hasSeats = m_eachSeat->isChecked(),
            .seats = m_seats->value(),
            .readOnly = m_readOnly->isChecked()};
}

void OfferForm::showChoices()
{
    m_seats->setEnabled(m_eachSeat->isChecked());
    m_warning->setText(reachesOthers(m_address->currentData().toString())
                           ? tr("Modbus has no password: whoever reaches this port in the network may use "
                                "the ring.")
                           : tr("Only programs on this computer reach it."));
}

} // namespace codewheel
